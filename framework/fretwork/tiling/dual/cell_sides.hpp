// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/tiling/dual/dual.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace fretwork::tiling::detail {

/// A side of one cell, between two vertices of the dual in the cell's direction.
struct CellSide {
    DualVertexIndex from;
    DualVertexIndex to;
    std::size_t cell = 0;
    /// The smaller end and the larger one: the same for the cell on the other side.
    [[nodiscard]] std::pair<DualVertexIndex, DualVertexIndex> ends() const { return std::minmax(from, to); }
};

/// The sides of all cells, ascending by their ends; of equal ends in the order of the cells. Throws Stopped.
std::vector<CellSide> sides_of_cells(const Dual& dual, const base::Control& control);

/// Call body for each pair of ends in turn, with the sides of the cells that have it. Throws Stopped.
template <class Body>
void for_each_side(std::span<const CellSide> sides, const base::Control& control, const Body& body) {
    while (!sides.empty()) {
        control.check();
        const auto others = std::ranges::find_if(
            sides, [&](const CellSide& side) { return side.ends() != sides.front().ends(); });
        const std::size_t count = others - sides.begin();
        body(sides.first(count));
        sides = sides.subspan(count);
    }
}

/// Around a cell from the second end of its side to the first, and then around the cell on the other side.
Cell union_of(Cell first, Cell other, const CellSide& side);

/// The mean length of the sides of the cells that have this side, metres.
double mean_side_beside(const Dual& dual, std::span<const CellSide> same);

}  // namespace fretwork::tiling::detail
