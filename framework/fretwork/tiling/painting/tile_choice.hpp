// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/box.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <string_view>
#include <vector>

namespace fretwork::tiling {

/// The smallest box around all tiles; all zeros if there are none.
geometry::Box bounding_box(const Tessellation& tessellation);

/// The centroid of each tile. A tile lies in a box, a circle or a polygon if its centroid does. Both
/// tile_centers() and tiles_in() throw GeometryError if a tile has no area.
base::IndexVector<TileIndex, geometry::Point2> tile_centers(const Tessellation& tessellation);

/// The tiles in a list of numbers and ranges ("3,7-11"), each tile once, ascending. Throws InputError that
/// states the valid numbers, or names a range that runs backwards.
std::vector<TileIndex> parse_tiles(std::string_view text, const Tessellation& tessellation);

/// The tiles in a box, its edge included; empty if there are none.
std::vector<TileIndex> tiles_in(const geometry::Box& box, const Tessellation& tessellation);
/// The tiles in a circle, its edge included; empty if there are none.
std::vector<TileIndex> tiles_in(const geometry::Circle& circle, const Tessellation& tessellation);
/// The tiles in a polygon; empty if there are none.
std::vector<TileIndex> tiles_in(const geometry::Polygon& polygon, const Tessellation& tessellation);

}  // namespace fretwork::tiling
