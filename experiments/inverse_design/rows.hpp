// SPDX-License-Identifier: GPL-3.0-or-later
// One row of a table; tables.py names its columns.
#pragma once

#include <fretwork/design/design.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace fretwork::experiments {

struct Row {
    std::string method;
    std::size_t tiles = 0;
    std::string target;
    std::string palette;
    std::uint64_t seed = 0;
    double bent = NAN;  ///< the largest displacement wanted over the span
    /// Mean distance of the best single pattern from the target, a share of the largest displacement wanted.
    double uniform = NAN;
    double error = NAN;  ///< the same distance of the design
    int solutions = 0;
    int full_solutions = 0;
    std::size_t patterns = 0;
    long swaps = 0;
    double seconds = NAN;  ///< processor time
    double unit = NAN;     ///< s, processor time of one corotational solution from rest
    double half = NAN;     ///< s, until the misfit had come to half of the best single pattern's
    double model_error = NAN;
    std::string end;
    double equal = NAN;    ///< tiles that have the pattern of the hidden painting
    double relaxed = NAN;  ///< misfit that mixtures of patterns are predicted to reach
    double outside = NAN;  ///< share of the tiles whose wanted curvatures are outside of the gamut
};

/// Set the figures of a row that a design reports.
inline void take_report(const design::DesignReport& report, Row& row) {
    if (report.error) row.error = report.error->mean;
    row.solutions = report.solutions;
    row.full_solutions = report.full_solutions;
    row.patterns = report.patterns.size();
    row.swaps = report.swaps_scored;
    row.model_error = report.model_error;
    row.end = design::design_end_name(report.end);
    row.relaxed = report.relaxed.value_or(NAN);
    row.outside = report.gamut.share_outside().value_or(NAN);
}

inline void print(const Row& row) {
    std::printf(
        "%s,%zu,%s,%s,%llu,%.3f,%.6f,%.6f,%.4f,%d,%d,%zu,%ld,%.3f,%.5f,%.0f,%.0f,%.6f,%s,%.0f,%.6f,%.3f\n",
        row.method.c_str(), row.tiles, row.target.c_str(), row.palette.c_str(),
        static_cast<unsigned long long>(row.seed), row.bent, row.uniform, row.error, row.error / row.uniform,
        row.solutions, row.full_solutions, row.patterns, row.swaps, row.seconds, row.unit,
        row.seconds / row.unit, row.half / row.unit, row.model_error, row.end.c_str(), row.equal, row.relaxed,
        row.outside);
}

}  // namespace fretwork::experiments
