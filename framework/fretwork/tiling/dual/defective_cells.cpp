// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/edits.hpp>

#include <algorithm>

namespace fretwork::tiling::detail {
namespace {

/// A cell to be removed, and the sides that it shares with other cells.
class Removal {
  public:
    Removal(const Dual& dual, std::size_t cell, const base::Control& control) : dual_(dual), cell_(cell) {
        for_each_side(sides_of_cells(dual, control), control, [&](std::span<const CellSide> same) {
            if (same.size() != 2) return;
            if (same[0].cell == cell) shared_.push_back({same[0], same[1].cell});
            if (same[1].cell == cell) shared_.push_back({same[1], same[0].cell});
        });
    }

    std::vector<Dual> run(double most_area) {
        std::vector<Dual> results;
        if (is_end() && geometry::signed_area(polygon_of(dual_, cell_)) <= most_area)
            results.push_back(with(cell_, {}));
        for (const Shared& shared : shared_) {
            const Cell merged = union_with(shared);
            if (merged.empty()) continue;
            results.push_back(with(shared.other, merged));
        }
        return results;
    }

  private:
    struct Shared {
        CellSide side;
        std::size_t other;
    };
    [[nodiscard]] const DualVertex& vertex(DualVertexIndex v) const { return dual_.vertices[v]; }

    /// True if the cell is the end of a limb: a single side, from rim to rim, connects it to other cells.
    [[nodiscard]] bool is_end() const {
        if (shared_.size() != 1) return false;
        const auto [from, to] = shared_.front().side.ends();
        return vertex(from).loop.is_valid() && vertex(from).loop == vertex(to).loop;
    }

    /// The union of the neighbour and the cell; empty if it is not convex. If the union is not convex at an
    /// end of the shared side, this end is left out, provided that no third cell has it.
    [[nodiscard]] Cell union_with(const Shared& shared) const {
        Cell merged = union_of(dual_.cells[cell_], dual_.cells[shared.other], shared.side);
        for (const DualVertexIndex end : {shared.side.from, shared.side.to}) {
            if (std::ranges::count(merged, end) != 1) return {};
            if (uses(end) == 2 && !is_convex_at(merged, end)) std::erase(merged, end);
        }
        return merged.size() >= 3 && geometry::is_convex(polygon(merged)) ? merged : Cell{};
    }
    [[nodiscard]] std::ptrdiff_t uses(DualVertexIndex v) const {
        return std::ranges::count_if(dual_.cells,
                                     [&](const Cell& cell) { return std::ranges::count(cell, v) > 0; });
    }
    [[nodiscard]] geometry::Polygon polygon(const Cell& cell) const {
        geometry::Polygon result;
        for (const DualVertexIndex v : cell) result.push_back(vertex(v).place);
        return result;
    }
    [[nodiscard]] bool is_convex_at(const Cell& cell, DualVertexIndex v) const {
        const std::size_t i = std::ranges::find(cell, v) - cell.begin();
        const std::size_t count = cell.size();
        const DualVertexIndex before = cell[(i + count - 1) % count];
        const DualVertexIndex after = cell[(i + 1) % count];
        return geometry::is_convex({vertex(before).place, vertex(v).place, vertex(after).place});
    }

    [[nodiscard]] Dual with(std::size_t changed, const Cell& vertices) const {
        Dual result = dual_;
        result.cells[changed] = vertices;
        result.cells.erase(result.cells.begin() + cell_);
        return result;
    }

    const Dual& dual_;
    std::size_t cell_;
    std::vector<Shared> shared_;
};

}  // namespace

std::vector<Dual> without_cell(const Dual& dual, std::size_t cell, double most_area,
                               const base::Control& control) {
    return Removal(dual, cell, control).run(most_area);
}

}  // namespace fretwork::tiling::detail
