// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/work.hpp>
#include <fretwork/tiling/remeshing/rim.hpp>

#include <array>
#include <vector>

namespace fretwork::tiling::detail {

using TriangleIndex = base::Index<struct TriangleTag>;

/// A triangulation of the inside of a rim. Its points are the rim's, in their order, then the sites.
struct Triangulation {
    int rim_count = 0;
    base::IndexVector<PointIndex, geometry::Point2> points;
    /// Counterclockwise, in an order that only the points decide.
    base::IndexVector<TriangleIndex, std::array<PointIndex, 3>> triangles;
    /// The triangle behind the side opposite to each corner; none: that side is on the rim.
    base::IndexVector<TriangleIndex, std::array<TriangleIndex, 3>> neighbors;
    [[nodiscard]] bool is_rim(PointIndex point) const { return point < rim_count; }
};

/// Constrained Delaunay triangulation: the rim's sides are edges, and no triangle is outside. The sites must
/// lie strictly inside, at different places.
Triangulation triangulate(const Rim& rim, const std::vector<geometry::Point2>& sites, const Work& work);

/// The middle of the circle through three points that turn left or right.
geometry::Point2 circumcenter(geometry::Point2 a, geometry::Point2 b, geometry::Point2 c);

/// The corner of a triangle at which a point is.
inline int corner_at(const std::array<PointIndex, 3>& triangle, PointIndex point) {
    return triangle[0] == point ? 0 : triangle[1] == point ? 1 : 2;
}

/// Give the corners of the outline that triangles of three rim points cut off to the tiles behind them: the
/// edge between is flipped where the two triangles make a convex quadrilateral. Throws base::Stopped.
void flip_ears(Triangulation& triangulation, const Work& work);

/// The ends of an edge inside that joins two points of the rim.
struct Chord {
    PointIndex from;
    PointIndex to;
};
/// The remaining edges of this kind. Where one lies, the tiles on both sides of it share no side, or a part
/// of the outline has no tile.
std::vector<Chord> chords_of(const Triangulation& triangulation);

}  // namespace fretwork::tiling::detail
