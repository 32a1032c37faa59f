// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/base/index_vector.hpp>
#include <fretwork/outlines/outline.hpp>
#include <fretwork/tiling/remeshing/closed_curve.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>

#include <vector>

namespace fretwork::tiling::detail {

/// The index of a loop of the outline. 0: the boundary; 1, 2, ..: the holes.
using LoopIndex = base::Index<struct LoopTag>;
/// The index of a point of a rim, or of the triangulation inside it. The points of the rim are the
/// triangulation's first points.
using PointIndex = base::Index<struct PointTag>;

/// A point on the outline.
struct RimPoint {
    geometry::Point2 place;
    LoopIndex loop{0};
    double along = 0.0;      ///< arc length of the point on the loop's curve, m
    bool is_corner = false;  ///< true if the point is a corner of the outline, which does not move
};

/// An outline with points on it at even distances: the protected border of the triangulation.
struct Rim {
    base::IndexVector<LoopIndex, ClosedCurve> curves;  ///< the outline itself
    base::IndexVector<PointIndex, RimPoint> points;    ///< loop by loop, in the direction of the outline
    base::IndexVector<PointIndex, PointIndex> next;    ///< for each point, the next point of its loop
};

/// Put points on the outline's corners, and further points evenly between two corners, at about the wanted
/// distances. Throws base::Stopped.
Rim sample_rim(const outlines::Outline& outline, const Spacing& spacing, const base::Control& control);

/// The places where the polygons through the rim's points cross or touch each other, found exactly. There,
/// the points are too far apart for the gap between two stretches of the outline. Throws base::Stopped.
std::vector<geometry::Point2> rim_crossings(const Rim& rim, const base::Control& control);

}  // namespace fretwork::tiling::detail
