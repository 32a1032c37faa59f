// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/dual/cell_sides.hpp>

#include <utility>

namespace fretwork::tiling::detail {
namespace {

template <class Body>
void for_each_cell_side(const Dual& dual, const base::Control& control, const Body& body) {
    for (std::size_t c = 0; c < dual.cells.size(); ++c) {
        control.check();
        const Cell& cell = dual.cells[c];
        for (std::size_t i = 0; i < cell.size(); ++i) body(CellSide{cell[i], cell[(i + 1) % cell.size()], c});
    }
}

}  // namespace

/// Sort by the smaller end first, by counting, because a counting sort can be stopped and std::sort cannot.
std::vector<CellSide> sides_of_cells(const Dual& dual, const base::Control& control) {
    std::vector<std::size_t> start(dual.vertices.size() + 1, 0);
    const auto smaller_end = [](const CellSide& side) -> std::size_t { return side.ends().first; };
    for_each_cell_side(dual, control, [&](const CellSide& side) { ++start[smaller_end(side) + 1]; });
    for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
    std::vector<CellSide> sides(start.back());
    std::vector<std::size_t> next = start;
    for_each_cell_side(dual, control, [&](const CellSide& side) { sides[next[smaller_end(side)]++] = side; });
    const auto key = [](const CellSide& side) { return std::pair(side.ends().second, side.cell); };
    for (std::size_t v = 0; v + 1 < start.size(); ++v) {
        control.check();
        std::ranges::sort(std::span(sides).subspan(start[v], start[v + 1] - start[v]), {}, key);
    }
    return sides;
}

Cell union_of(Cell first, Cell other, const CellSide& side) {
    std::ranges::rotate(first, std::ranges::find(first, side.to));
    std::ranges::rotate(other, std::ranges::find(other, side.from));
    first.insert(first.end(), other.begin() + 1, other.end() - 1);
    return first;
}

double mean_side_beside(const Dual& dual, std::span<const CellSide> same) {
    double mean = 0.0;
    for (const CellSide& side : same)
        mean += geometry::mean_side(polygon_of(dual, side.cell)) / static_cast<double>(same.size());
    return mean;
}

}  // namespace fretwork::tiling::detail
