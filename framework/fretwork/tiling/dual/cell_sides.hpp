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
    /// The two ends, the smaller index first: the same pair for the cells on both sides.
    [[nodiscard]] std::pair<DualVertexIndex, DualVertexIndex> ends() const { return std::minmax(from, to); }
};

/// The sides of all cells, sorted by ends() and then by cell. Throws Stopped.
std::vector<CellSide> sides_of_cells(const Dual& dual, const base::Control& control);

/// Call body for each pair of ends, with the sides of all cells that have this pair. Throws Stopped.
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

/// The union of two cells at a common side, which is in the direction of `first`. It lists the vertices of
/// `first` from the second end of the side to its first end, then the remaining vertices of `other`.
Cell union_of(Cell first, Cell other, const CellSide& side);

/// The mean side length of the cells that share a side, m. Each cell counts equally. `same` lists the side
/// once for each cell.
double mean_side_beside(const Dual& dual, std::span<const CellSide> same);

}  // namespace fretwork::tiling::detail
