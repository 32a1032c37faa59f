// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/box.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <string_view>
#include <vector>

namespace fretwork::tiling {

/// The smallest box around all tiles.
geometry::Box bounding_box(const Tessellation& tessellation);

/// The centroid of each tile: a tile lies where its centroid does.
base::IndexVector<TileIndex, geometry::Point2> tile_centers(const Tessellation& tessellation);

/// The tiles of numbers and ranges of numbers: "3,7-11". Each once, ascending. Throws InputError that names
/// what there is.
std::vector<TileIndex> parse_tiles(std::string_view text, const Tessellation& tessellation);

/// Whether a point lies inside a closed polygon, which may cross itself: it winds around the point.
bool is_inside(const geometry::Polygon& polygon, geometry::Point2 point);

/// The tiles in a box, its rim included; none is an empty list.
std::vector<TileIndex> tiles_in(const geometry::Box& box, const Tessellation& tessellation);
/// The tiles in a polygon.
std::vector<TileIndex> tiles_in(const geometry::Polygon& polygon, const Tessellation& tessellation);

}  // namespace fretwork::tiling
