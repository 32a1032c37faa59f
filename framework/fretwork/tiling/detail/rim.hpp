// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/tiling/detail/closed_curve.hpp>
#include <fretwork/tiling/outline.hpp>

#include <vector>

namespace fretwork::tiling::detail {

/// A point on the outline.
struct RimPoint {
    pattern::Point2 place;
    int loop = 0;            ///< 0: the boundary; 1, 2, ..: the holes
    bool is_corner = false;  ///< a corner of the outline: it stays where it is
};

/// An outline with points on it at even distances: the protected border of the triangulation.
struct Rim {
    std::vector<ClosedCurve> curves;  ///< the outline itself, loop by loop
    std::vector<RimPoint> points;     ///< loop by loop, in the direction of the outline
    std::vector<int> next;            ///< for each point the next point of the same loop
};

/// Put points on the outline's corners, and evenly between them at distances near `spacing` (metres). Where
/// the polygons through these points cross, the points lie half as far apart, and so on down to an eighth.
/// Throws GeometryError if that is no help: parts of the outline are much nearer to each other than a tile is
/// wide. Throws base::Stopped.
Rim sample_rim(const Outline& outline, double spacing, const base::Control& control);

}  // namespace fretwork::tiling::detail
