// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of tiles that fit a bed.
#pragma once

#include <fretwork/fabrication/sheets.hpp>

#include <vector>

namespace fretwork::fabrication::detail {

/// For each tile the number of its part. Parts are neighbouring tiles in a cell of a grid, as few as there
/// can be with equal cells, each with `reach` (m) around it no larger than the bed without its margins,
/// upright or turned by a quarter. Throws InputError that names a tile which does not fit.
base::IndexVector<TileIndex, std::size_t> parts_of_tiles(const tiling::Tessellation& tessellation,
                                                         const Bed& bed, double reach);

/// Where parts are put: sheet, place of the lower left corner, and whether they are turned by a quarter.
struct Nest {
    std::size_t sheet = 0;
    geometry::Point2 corner;
    bool turned = false;
};
/// Rows of boxes on sheets, the highest first. Every box fits the bed.
std::vector<Nest> nested(const std::vector<geometry::Box>& boxes, const Bed& bed);

}  // namespace fretwork::fabrication::detail
