// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>

#include <map>
#include <span>
#include <string>

namespace fretwork::library {

/// Statistics of the calibrations of one key over patterns.
struct CalibrationStatistics {
    std::size_t calibrated = 0;
    double mean = 0.0;       ///< of the objective E
    double deviation = 0.0;  ///< standard deviation of the population
    double median = 0.0;
    std::map<std::string, std::size_t> at_bound;  ///< patterns in which a parameter is at a bound, by name
    std::size_t samples = 0;                      ///< scenarios times magnitudes of these patterns
    std::size_t converged = 0;
    std::size_t limit_load = 0;  ///< of the others: beyond the largest load that the path reaches
    std::size_t unstable = 0;    ///< of those that converged
};

CalibrationStatistics calibration_statistics(const Library& library, std::span<const PatternEntry> patterns,
                                             const CalibrationKey& key);

}  // namespace fretwork::library
