// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/work.hpp>
#include <fretwork/tiling/remeshing/rim.hpp>

#include <array>
#include <vector>

namespace fretwork::tiling::detail {

/// A triangulation of the inside of a rim. Its points are the rim's, in their order, then the sites.
struct Triangulation {
    int rim_count = 0;
    std::vector<geometry::Point2> points;
    std::vector<std::array<int, 3>> triangles;  ///< counterclockwise, in an order that only the points decide
    /// The triangle behind the side opposite to each corner; -1: that side is on the rim.
    std::vector<std::array<int, 3>> neighbors;
    [[nodiscard]] bool is_rim(int point) const { return point < rim_count; }
};

/// Constrained Delaunay triangulation: the rim's sides are edges, and no triangle is outside. The sites must
/// lie strictly inside, at different places.
Triangulation triangulate(const Rim& rim, const std::vector<geometry::Point2>& sites, const Work& work);

/// The corner of a triangle at which a point is.
inline int corner_at(const std::array<int, 3>& triangle, int point) {
    return triangle[0] == point ? 0 : triangle[1] == point ? 1 : 2;
}

}  // namespace fretwork::tiling::detail
