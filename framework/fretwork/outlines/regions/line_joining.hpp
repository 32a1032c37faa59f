// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <vector>

namespace fretwork::outlines::detail {

/// Lines whose ends were brought together.
struct JoinedLines {
    std::vector<geometry::Polygon> lines;  ///< those given, less the doubled ones, then those that close gaps
    std::vector<std::size_t> given;  ///< for each line, which of the given ones it is (or is nearest to)
    int gaps = 0;
    double widest_gap = 0.0;  ///< metres
    int doubled = 0;
};

/// Distances in metres.
struct JoiningTolerance {
    double same;  ///< ends nearer than this to each other are one point, to a line a point of it; lines
                  ///< nearer than this all along are one line
    double gap;   ///< an end that hangs loose is joined with the next loose end up to this distance, the
                  ///< nearest first
};

/// Bring the ends of open polylines (two points or more) together.
JoinedLines join_lines(const std::vector<geometry::Polygon>& lines, const JoiningTolerance& tolerance);

/// Closed curves without those that are drawn twice.
struct DistinctCurves {
    std::vector<geometry::Polygon> curves;
    int doubled = 0;
};
DistinctCurves distinct_curves(std::vector<geometry::Polygon> curves, double same);

}  // namespace fretwork::outlines::detail
