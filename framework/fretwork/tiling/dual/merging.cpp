// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/edits.hpp>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <optional>
#include <tuple>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

// Share of the largest wanted side; cells with a smaller wanted side may be merged.
constexpr double kSmaller = 0.8;
constexpr double kLongest = 1.5;  // largest side of a merged cell, over the largest wanted side
constexpr double kBend = 0.04;  // share of a side's length; a point of the rim nearer to the side is left out
constexpr double kSharpest = 35 * std::numbers::pi / 180;

class Merger {
  public:
    Merger(Dual& dual, const SizeField& field, const base::Control& control)
        : dual_(dual), field_(field), control_(control), uses_(dual.vertices.size(), 0) {
        for (const Cell& cell : dual.cells) {
            for (const DualVertexIndex v : cell) ++uses_[v];
        }
    }

    void run() {
        while (merge_some()) {
        }
        std::erase_if(dual_.cells, [](const Cell& cell) { return cell.empty(); });
    }

  private:
    [[nodiscard]] Point2 place(DualVertexIndex v) const { return dual_.vertices[v].place; }

    /// Merge pairs of cells, the smallest pairs first, each cell at most once. Returns true if cells were
    /// merged.
    bool merge_some() {
        struct Pair {
            double size;
            CellSide side;
            std::size_t other;
        };
        std::vector<Pair> pairs;
        const auto sides = sides_of_cells(dual_, control_);
        for_each_side(sides, control_, [&](std::span<const CellSide> same) {
            if (same.size() != 2) return;
            const Point2 middle = between(place(same[0].from), place(same[0].to), 0.5);
            if (field_.at(middle) > kSmaller * field_.largest()) return;
            const double size = geometry::signed_area(polygon_of(dual_, same[0].cell)) +
                                geometry::signed_area(polygon_of(dual_, same[1].cell));
            pairs.push_back({size, same[0], same[1].cell});
        });
        std::ranges::sort(pairs, {},
                          [](const Pair& p) { return std::tuple(p.size, p.side.from, p.side.to); });
        std::vector<bool> is_touched(dual_.cells.size(), false);
        bool has_merged = false;
        for (const Pair& pair : pairs) {
            if (is_touched[pair.side.cell] || is_touched[pair.other]) continue;
            if (!merge(pair.side, pair.other)) continue;
            is_touched[pair.side.cell] = is_touched[pair.other] = true;
            has_merged = true;
        }
        return has_merged;
    }

    bool merge(const CellSide& side, std::size_t other) {
        Cell merged = union_of(dual_.cells[side.cell], dual_.cells[other], side);
        Cell superfluous{side.from, side.to};
        std::ranges::copy_if(merged, std::back_inserter(superfluous),
                             [&](DualVertexIndex v) { return dual_.vertices[v].divides_side; });
        for (const DualVertexIndex v : superfluous) {
            if (std::ranges::count(merged, v) != 1) return false;
            if (may_go(v, merged)) std::erase(merged, v);
        }
        if (!is_good(merged)) return false;
        for (const std::size_t cell : {side.cell, other}) {
            for (const DualVertexIndex v : dual_.cells[cell]) --uses_[v];
        }
        for (const DualVertexIndex v : merged) ++uses_[v];
        dual_.cells[side.cell] = std::move(merged);
        dual_.cells[other].clear();
        return true;
    }
    /// True if a vertex may be removed: it lies on the rim, belongs to these two cells alone, is not a
    /// corner, and lies nearly on the line between its neighbours.
    [[nodiscard]] bool may_go(DualVertexIndex v, const Cell& cell) const {
        const DualVertex& vertex = dual_.vertices[v];
        if (!vertex.loop.is_valid() || vertex.is_fixed || uses_[v] > 2) return false;
        const std::size_t i = std::ranges::find(cell, v) - cell.begin();
        const Point2 before = place(cell[(i + cell.size() - 1) % cell.size()]);
        const Point2 after = place(cell[(i + 1) % cell.size()]);
        return distance(nearest_on_segment(before, after, vertex.place), vertex.place) <
               kBend * distance(before, after);
    }
    [[nodiscard]] bool is_good(const Cell& cell) const {
        Polygon polygon;
        for (const DualVertexIndex v : cell) polygon.push_back(place(v));
        if (!geometry::is_convex(polygon)) return false;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point2 here = polygon[(i + 1) % polygon.size()];
            const Point2 side = polygon[(i + 2) % polygon.size()] - here;
            if (length(side) > kLongest * field_.largest()) return false;
            if (turn(side, polygon[i] - here) < kSharpest) return false;
        }
        return true;
    }

    Dual& dual_;
    const SizeField& field_;
    const base::Control& control_;
    base::IndexVector<DualVertexIndex, int> uses_;
};

}  // namespace

void merge_small_cells(Dual& dual, const SizeField& field, const base::Control& control) {
    Merger(dual, field, control).run();
}

}  // namespace fretwork::tiling::detail
