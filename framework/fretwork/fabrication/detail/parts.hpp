// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of tiles that fit a bed.
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/fabrication/sheets.hpp>
#include <fretwork/geometry/box.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <vector>

namespace fretwork::fabrication::detail {

/// The room that parts of a surface need.
struct PartRoom {
    double reach = 0.0;      ///< length by which material lies beyond the tiles of a part, m
    double connector = 0.0;  ///< free length around each connector, m
    base::Control control{};
    std::vector<geometry::Point2> holes{};  ///< holes that no connector may fill, m
    double hole_radius = 0.0;               ///< m
};

/// For each tile the number of its part. Parts are neighbouring tiles in a cell of a grid; then tiles along
/// the seams change parts until every connector has room. Up to six grids are tried, the grid with the fewest
/// cells first. Each part with the reach around it is no larger than the bed without its margins, upright or
/// turned by a quarter. If no grid gives every connector room, the result is the first grid, and some
/// connectors have too little room. Throws InputError that names a tile that does not fit, and Stopped.
base::IndexVector<TileIndex, std::size_t> parts_of_tiles(const tiling::Tessellation& tessellation,
                                                         const Bed& bed, const PartRoom& room);

/// The place of a part: its sheet, the lower left corner of its box, and true if it is turned by a quarter.
struct Nest {
    std::size_t sheet = 0;
    geometry::Point2 corner;
    bool is_turned = false;
};
/// Put boxes into rows on sheets, the highest box first. Pre: every box fits the bed.
std::vector<Nest> nested(const std::vector<geometry::Box>& boxes, const Bed& bed);

}  // namespace fretwork::fabrication::detail
