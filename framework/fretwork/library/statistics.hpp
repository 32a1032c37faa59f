// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace fretwork::library {

/// A calibration whose objective lies far above those of its like: its search may have failed.
struct FarAbove {
    std::string pattern;  ///< id
    double objective = 0.0;
};

/// An objective E above this is an outlier; infinity if there are fewer than 20 calibrations, too few to
/// judge.
///
/// log E of the calibrations of one key is about normal. The limit lies four deviations above its median, by
/// the median absolute deviation, which failed searches do not move: about one sound E in 30,000 lies above.
/// It is at least ten times the median, so that patterns which are all alike are not doubted.
double far_above_limit(std::vector<double> objectives);

/// Statistics of the calibrations of one key over patterns.
struct CalibrationStatistics {
    std::size_t calibrated = 0;
    double mean = 0.0;       ///< of the objective E
    double deviation = 0.0;  ///< standard deviation of the population
    double median = 0.0;
    double far_above_limit = 0.0;  ///< by all calibrations of the key that the library has
    std::vector<FarAbove> far_above;
    std::map<std::string, std::size_t> at_bound;  ///< patterns in which a parameter is at a bound, by name
    std::size_t samples = 0;                      ///< scenarios times magnitudes of these patterns
    std::size_t converged = 0;
    std::size_t limit_load = 0;  ///< of the others: beyond the largest load that the path reaches
    std::size_t unstable = 0;    ///< of those that converged
};

CalibrationStatistics calibration_statistics(const Library& library,
                                             std::span<const pattern::NamedPattern> patterns,
                                             const CalibrationKey& key);

}  // namespace fretwork::library
