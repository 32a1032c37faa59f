// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace fretwork::library {

/// A calibration with an objective far above those of comparable calibrations. Its search may have failed.
struct FarAbove {
    std::string pattern;     ///< pattern id
    double objective = 0.0;  ///< E
};

/// The limit above which an objective E is an outlier. Infinity for fewer than 20 calibrations, which are too
/// few for an estimate, and if the median of E is 0, to which no ratio exists.
///
/// Over the calibrations of one key, log E is about normally distributed. The limit lies four standard
/// deviations above the median of log E, so about one sound calibration in 30,000 has an E above the limit.
/// The standard deviation is estimated from the median absolute deviation, which failed searches hardly
/// change. The limit is at least ten times the median of E, so that very similar patterns give no outliers.
double far_above_limit(std::vector<double> objectives);

/// Statistics of the calibrations of one key over patterns.
struct CalibrationStatistics {
    std::size_t calibrated = 0;  ///< number of patterns with a calibration
    double mean = 0.0;           ///< mean of the objective E
    double deviation = 0.0;      ///< standard deviation of E over these patterns
    double median = 0.0;         ///< median of E
    /// far_above_limit() of all calibrations of the key in the library
    double far_above_limit = 0.0;
    std::vector<FarAbove> far_above;  ///< patterns with E above far_above_limit
    /// For each parameter, the number of patterns with this parameter at a bound.
    std::map<std::string, std::size_t> at_bound;
    /// Number of samples of these patterns, scenarios times magnitudes.
    std::size_t samples = 0;
    std::size_t converged = 0;  ///< number of converged samples
    /// Number of samples that have not converged because their load is above the largest load of the path.
    std::size_t limit_load = 0;
    std::size_t unstable = 0;  ///< number of converged samples that are not stable
};

/// The statistics of the calibrations of `key` over `patterns`.
CalibrationStatistics calibration_statistics(const Library& library,
                                             std::span<const pattern::NamedPattern> patterns,
                                             const CalibrationKey& key);

}  // namespace fretwork::library
