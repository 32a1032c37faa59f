// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <vector>

namespace fretwork::outlines::detail {

/// Lines after joining their ends.
struct JoinedLines {
    /// The given lines without repeated lines, then the lines that close gaps.
    std::vector<geometry::Polygon> lines;
    /// For each of `lines`, the index of its given line; for a line that closes a gap, of one given line at
    /// the gap.
    std::vector<std::size_t> given;
    int gaps = 0;
    double widest_gap = 0.0;  ///< metres
    int doubled = 0;
};

/// The distances, in metres, at which lines are joined.
struct JoiningTolerance {
    double same;  ///< ends nearer than this are one point; an end nearer than this to a line lies on it;
                  ///< lines with the same ends, and about the same middle, length and course, are one
    double gap;   ///< loose ends up to this distance apart are joined, the nearest pair first; a line is
                  ///< joined to itself only if it is more than four times as long
};

/// Join the ends of open polylines of two points or more. Throws GeometryError if millions of pairs of loose
/// ends could be joined.
JoinedLines join_lines(const std::vector<geometry::Polygon>& lines, const JoiningTolerance& tolerance);

/// Closed curves without repeated curves. Curves are the same if their boxes agree up to `same` (m), their
/// areas agree up to `same` times the perimeter, and each lies on the other, up to flattening.
struct DistinctCurves {
    std::vector<geometry::Polygon> curves;
    int doubled = 0;
};
DistinctCurves distinct_curves(std::vector<geometry::Polygon> curves, double same);

}  // namespace fretwork::outlines::detail
