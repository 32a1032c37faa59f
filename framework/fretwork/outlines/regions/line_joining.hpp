// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <vector>

namespace fretwork::outlines::detail {

/// Lines after joining their ends.
struct JoinedLines {
    std::vector<geometry::Polygon> lines;  ///< the given lines without doubled ones, then the lines that
                                           ///< close gaps
    std::vector<std::size_t> given;  ///< for each line, the index of the given line that it is, or is nearest
                                     ///< to
    int gaps = 0;
    double widest_gap = 0.0;  ///< metres
    int doubled = 0;
};

/// The distances, in metres, at which lines are joined.
struct JoiningTolerance {
    double same;  ///< ends nearer than this are one point; an end nearer than this to a line lies on it;
                  ///< lines nearer than this along their whole length are one line
    double gap;   ///< loose ends up to this distance apart are joined, the nearest pair first
};

/// Join the ends of open polylines of two points or more.
JoinedLines join_lines(const std::vector<geometry::Polygon>& lines, const JoiningTolerance& tolerance);

/// Closed curves without doubled ones.
struct DistinctCurves {
    std::vector<geometry::Polygon> curves;
    int doubled = 0;
};
DistinctCurves distinct_curves(std::vector<geometry::Polygon> curves, double same);

}  // namespace fretwork::outlines::detail
