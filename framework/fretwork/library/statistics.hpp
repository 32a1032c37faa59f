// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace fretwork::library {

/// A calibration whose objective lies far above those of comparable calibrations. Its search may have failed.
struct FarAbove {
    std::string pattern;     ///< id
    double objective = 0.0;  ///< E
};

/// The limit above which an objective E is an outlier. Infinity for fewer than 20 calibrations, which are too
/// few.
///
/// log E of the calibrations of one key is about normally distributed. The limit lies four standard
/// deviations above the median of log E, so about one sound E in 30,000 exceeds it. The deviation is
/// estimated by the median absolute deviation, which failed searches hardly change. The limit is at least ten
/// times the median of E, so that very similar patterns give no outliers.
double far_above_limit(std::vector<double> objectives);

/// Statistics of the calibrations of one key over patterns.
struct CalibrationStatistics {
    std::size_t calibrated = 0;                   ///< patterns with a calibration
    double mean = 0.0;                            ///< mean of the objective E
    double deviation = 0.0;                       ///< standard deviation of the population
    double median = 0.0;                          ///< of E
    double far_above_limit = 0.0;                 ///< from all calibrations of the key in the library
    std::vector<FarAbove> far_above;              ///< patterns whose E is far above the median
    std::map<std::string, std::size_t> at_bound;  ///< for each parameter, the number of patterns in which it
                                                  ///< is at a bound
    std::size_t samples = 0;                      ///< scenarios times magnitudes of these patterns
    std::size_t converged = 0;                    ///< of the samples
    std::size_t limit_load = 0;  ///< samples beyond the largest load that the path reaches; they have not
                                 ///< converged
    std::size_t unstable = 0;    ///< converged samples that are not stable
};

/// The statistics of one model, optimizer and budget.
CalibrationStatistics calibration_statistics(const Library& library,
                                             std::span<const pattern::NamedPattern> patterns,
                                             const CalibrationKey& key);

}  // namespace fretwork::library
