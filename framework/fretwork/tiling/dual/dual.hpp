// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/work.hpp>
#include <fretwork/tiling/remeshing/rim.hpp>
#include <fretwork/tiling/remeshing/triangulation.hpp>

#include <vector>

namespace fretwork::tiling::detail {

using DualVertexIndex = base::Index<struct DualVertexTag>;
/// The vertices of a tile, counterclockwise.
using Cell = std::vector<DualVertexIndex>;

/// A vertex of the dual.
struct DualVertex {
    geometry::Point2 place;
    LoopIndex loop{};       ///< the loop of the outline on which the vertex lies; invalid: it lies inside
    bool is_fixed = false;  ///< true if the vertex is a corner of the outline
    double along = 0.0;     ///< arc length of the vertex on the loop's curve, m
    /// True if the vertex divides a long side on the rim. Such a vertex lies on the outline or, if the
    /// outline runs inside the tile, on the straight line between its neighbours.
    bool divides_side = false;
};

/// The tiles of a triangulation, one for each site: polygons that share vertices and whole sides, closed
/// along the outline.
struct Dual {
    base::IndexVector<DualVertexIndex, DualVertex> vertices;
    std::vector<Cell> cells;  ///< one for each site
};

/// The dual of a triangulation. A triangle of three sites gives an inner vertex: the circumcenter, or the
/// point of the triangle nearest to the circumcenter. In a triangle of two sites and a rim point, the side
/// between the two tiles ends on the outline. A corner of the outline is a vertex of its tile if the tile
/// stays convex. Pre: ears have been flipped (flip_ears).
Dual dual_of(const Rim& rim, const Triangulation& triangulation, const Work& work);

/// The polygon of a cell.
geometry::Polygon polygon_of(const Dual& dual, std::size_t cell);

}  // namespace fretwork::tiling::detail
