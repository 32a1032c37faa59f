// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/shared_task.hpp>
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
    LoopIndex loop{};  ///< the loop that carries the vertex; invalid if the vertex lies inside the outline
    bool is_fixed = false;  ///< true if the vertex is a corner of the outline
    double along = 0.0;     ///< arc length of the vertex on the loop's curve, m
    /// True if the vertex divides a long side of a tile along the outline. The vertex lies on the outline or,
    /// where the outline bends into the tile, on the straight line between the two vertices beside it, so
    /// that the tile is convex.
    bool divides_side = false;
};

/// The dual of a triangulation: a tile for each site. Tiles are polygons that share vertices and whole sides.
/// Tiles at the rim end on the outline.
struct Dual {
    base::IndexVector<DualVertexIndex, DualVertex> vertices;
    std::vector<Cell> cells;  ///< tiles, one for each site
};

/// The dual of a triangulation. A triangle of three sites gives an inner vertex: the circumcenter, or the
/// point of the triangle nearest to the circumcenter. In a triangle of two sites and a rim point, the side
/// between the two tiles ends on the outline. A corner of the outline is a vertex of its tile if the tile
/// stays convex. Throws base::Stopped. Pre: ears have been flipped (flip_ears).
Dual dual_of(const Rim& rim, const Triangulation& triangulation, const SharedTask& task);

/// The polygon of a tile.
geometry::Polygon polygon_of(const Dual& dual, std::size_t cell);

}  // namespace fretwork::tiling::detail
