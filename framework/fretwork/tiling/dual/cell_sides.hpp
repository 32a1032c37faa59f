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
    int from = -1;
    int to = -1;
    std::size_t cell = 0;
    /// The smaller end and the larger one: the same for the cell on the other side.
    [[nodiscard]] std::pair<int, int> ends() const { return std::minmax(from, to); }
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
        const auto count = static_cast<std::size_t>(others - sides.begin());
        body(sides.first(count));
        sides = sides.subspan(count);
    }
}

}  // namespace fretwork::tiling::detail
