// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/collapse.hpp>
#include <fretwork/tiling/detail/plane.hpp>

#include <algorithm>
#include <optional>

namespace fretwork::tiling::detail {
namespace {

using Cell = std::vector<int>;

bool has(const Cell& cell, int vertex) {
    return std::find(cell.begin(), cell.end(), vertex) != cell.end();
}

std::vector<std::size_t> cells_at(const Dual& dual, int vertex) {
    std::vector<std::size_t> cells;
    for (std::size_t c = 0; c < dual.cells.size(); ++c) {
        if (has(dual.cells[c], vertex)) cells.push_back(c);
    }
    return cells;
}

/// A triangle with one vertex inside, and one neighbour at each of its sides that ends there.
struct RimTriangle {
    std::size_t cell;
    int inner;                 // its vertex inside, where it meets two other cells
    std::array<int, 2> outer;  // its vertices on the outline
};

const DualVertex& vertex(const Dual& dual, int index) {
    return dual.vertices[static_cast<std::size_t>(index)];
}

std::optional<RimTriangle> rim_triangle(const Dual& dual, std::size_t cell) {
    const Cell& corners = dual.cells[cell];
    if (corners.size() != 3) return std::nullopt;
    const auto inner =
        std::find_if(corners.begin(), corners.end(), [&](int v) { return vertex(dual, v).loop < 0; });
    if (inner == corners.end()) return std::nullopt;
    const auto at = static_cast<std::size_t>(inner - corners.begin());
    const RimTriangle found{cell, *inner, {corners[(at + 1) % 3], corners[(at + 2) % 3]}};
    const DualVertex& first = vertex(dual, found.outer[0]);
    const DualVertex& second = vertex(dual, found.outer[1]);
    const bool joins_rim_points =
        first.loop >= 0 && first.loop == second.loop && !(first.is_fixed && second.is_fixed);
    if (!joins_rim_points || cells_at(dual, found.inner).size() != 3) return std::nullopt;
    for (const int outer : found.outer) {
        if (cells_at(dual, outer).size() != 2) return std::nullopt;
    }
    return found;
}

/// The neighbours lose a vertex each, and must have three left.
bool can_collapse(const Dual& dual, const RimTriangle& triangle) {
    const auto cells = cells_at(dual, triangle.inner);
    return std::all_of(cells.begin(), cells.end(), [&](std::size_t cell) {
        return cell == triangle.cell || dual.cells[cell].size() >= 5;
    });
}

void collapse(Dual& dual, const RimTriangle& triangle) {
    auto [kept, merged] = triangle.outer;
    if (vertex(dual, merged).is_fixed) std::swap(kept, merged);
    DualVertex& place = dual.vertices[static_cast<std::size_t>(kept)];
    if (!place.is_fixed) place.place = between(place.place, vertex(dual, merged).place, 0.5);
    dual.cells.erase(dual.cells.begin() + static_cast<std::ptrdiff_t>(triangle.cell));
    for (Cell& cell : dual.cells) {
        std::replace(cell.begin(), cell.end(), merged, kept);
        std::erase(cell, triangle.inner);
    }
}

}  // namespace

void collapse_rim_triangles(Dual& dual) {
    for (std::size_t cell = 0; cell < dual.cells.size();) {
        const auto triangle = rim_triangle(dual, cell);
        if (triangle && can_collapse(dual, *triangle))
            collapse(dual, *triangle);
        else
            ++cell;
    }
}

}  // namespace fretwork::tiling::detail
