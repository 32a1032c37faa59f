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
    LoopIndex loop{};       ///< the loop of the outline on which it lies; none: inside
    bool is_fixed = false;  ///< on a corner of the outline
    double along = 0.0;     ///< its place on the loop's curve
    /// It divides a long side on the rim: on the outline or, where that runs inside of the tile, on the
    /// straight line between its neighbours.
    bool divides_side = false;
};

/// The tiles of a triangulation, one for each site: polygons that share vertices and whole sides, closed
/// along the outline.
struct Dual {
    base::IndexVector<DualVertexIndex, DualVertex> vertices;
    std::vector<Cell> cells;  ///< one for each site
};

/// The dual of a triangulation. A triangle of three sites gives an inner vertex (its circumcenter, or the
/// nearest point of the triangle); where two sites and a point of the rim make a triangle, the side between
/// the two tiles ends on the outline. The outline's corners are vertices of the tiles in which they lie,
/// where these stay convex. Ears must have been flipped.
Dual dual_of(const Rim& rim, const Triangulation& triangulation, const Work& work);

/// The polygon of a cell.
geometry::Polygon polygon_of(const Dual& dual, std::size_t cell);

}  // namespace fretwork::tiling::detail
