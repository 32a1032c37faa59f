// SPDX-License-Identifier: GPL-3.0-or-later
// One row of a table; tables.py names its columns.
#pragma once

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
    double uniform =
        NAN;  ///< mean distance of the best single pattern, a share of the largest displacement wanted
    double error = NAN;  ///< that of the design
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
