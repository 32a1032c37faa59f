// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/shared_task.hpp>
#include <fretwork/tiling/remeshing/rim.hpp>

#include <array>
#include <vector>

namespace fretwork::tiling::detail {

using TriangleIndex = base::Index<struct TriangleTag>;

/// A triangulation of the inside of a rim. The first points are the points of the rim, in their order; the
/// sites follow.
struct Triangulation {
    int rim_count = 0;
    base::IndexVector<PointIndex, geometry::Point2> points;
    /// Triangles, counterclockwise, in an order that depends on the points alone.
    base::IndexVector<TriangleIndex, std::array<PointIndex, 3>> triangles;
    /// For each triangle, the neighbour across the side opposite to each corner; invalid if that side is on
    /// the rim.
    base::IndexVector<TriangleIndex, std::array<TriangleIndex, 3>> neighbors;
    [[nodiscard]] bool is_rim(PointIndex point) const { return point < rim_count; }
};

/// The constrained Delaunay triangulation: the rim's sides are edges, and no triangle lies outside. Throws
/// base::Stopped. Pre: the sites lie strictly inside and are distinct.
Triangulation triangulate(const Rim& rim, const std::vector<geometry::Point2>& sites, const SharedTask& task);

/// The center of the circle through three points, which must not lie on a line.
geometry::Point2 circumcenter(geometry::Point2 a, geometry::Point2 b, geometry::Point2 c);

/// The corner (0, 1 or 2) of a triangle at which a point lies.
inline int corner_at(const std::array<PointIndex, 3>& triangle, PointIndex point) {
    return triangle[0] == point ? 0 : triangle[1] == point ? 1 : 2;
}

/// Flip ears. An ear is a triangle with two sides on the rim; it cuts off a corner of the outline. Flipping
/// its inner edge gives the corner to the tile behind the ear. The edge is flipped if the point behind it is
/// a site, and if its two triangles form a convex quadrilateral. Throws base::Stopped.
void flip_ears(Triangulation& triangulation, const SharedTask& task);

/// An inner edge that joins two points of the rim.
struct Chord {
    PointIndex from;
    PointIndex to;
};
/// All chords of a triangulation. The tiles to the left and right of a chord share no side, or one of them is
/// missing.
std::vector<Chord> chords_of(const Triangulation& triangulation);

}  // namespace fretwork::tiling::detail
