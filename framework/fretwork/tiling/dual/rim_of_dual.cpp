// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/disjoint_sets.hpp>
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/rim_of_dual.hpp>

#include <algorithm>

namespace fretwork::tiling::detail {

DualRim rim_of(const Dual& dual, const base::Control& control) {
    DualRim rim;
    base::IndexVector<DualVertexIndex, DualVertexIndex> next(dual.vertices.size());
    const auto sides = sides_of_cells(dual, control);
    for_each_side(sides, control, [&](std::span<const CellSide> same) {
        const CellSide& side = same.front();
        if (same.size() == 1) {
            DualVertexIndex& after = next[side.from];
            if (after.is_valid()) rim.knots.push_back(side.from);
            after = side.to;
        } else if (same.size() > 2 || same.back().from == side.from) {
            rim.knots.push_back(side.from);
        }
    });
    for (const DualVertexIndex first : next.indices()) {
        control.check();
        if (!next[first].is_valid()) continue;
        std::vector<DualVertexIndex>& line = rim.lines.emplace_back();
        for (DualVertexIndex at = first; at.is_valid();) {
            line.push_back(at);
            at = std::exchange(next[at], {});
        }
        // A closed line ends at its first vertex.
        if (line.size() > 1 && line.front() == line.back())
            line.pop_back();
        else
            rim.knots.push_back(line.back());
    }
    return rim;
}

std::vector<geometry::Polygon> loops_of(const Dual& dual, const DualRim& rim) {
    std::vector<geometry::Polygon> loops;
    for (const auto& line : rim.lines) {
        geometry::Polygon& loop = loops.emplace_back();
        for (const DualVertexIndex v : line) loop.push_back(dual.vertices[v].place);
    }
    std::iter_swap(loops.begin(), std::ranges::max_element(loops, {}, geometry::signed_area));
    return loops;
}

Pieces pieces_of(const Dual& dual, const base::Control& control) {
    base::DisjointSets connected(dual.cells.size());
    const auto sides = sides_of_cells(dual, control);
    for_each_side(sides, control, [&](std::span<const CellSide> same) {
        for (const CellSide& other : same.subspan(1)) connected.unite(other.cell, same.front().cell);
    });
    std::vector<std::size_t> sizes(dual.cells.size(), 0);
    for (std::size_t cell = 0; cell < sizes.size(); ++cell) ++sizes[connected.first_of(cell)];
    Pieces pieces;
    std::size_t smallest = dual.cells.size() + 1;
    for (std::size_t cell = 0; cell < sizes.size(); ++cell) {
        if (sizes[cell] == 0) continue;
        ++pieces.count;
        if (sizes[cell] < smallest) {
            smallest = sizes[cell];
            pieces.cell_of_smallest = cell;
        }
    }
    return pieces;
}

}  // namespace fretwork::tiling::detail
