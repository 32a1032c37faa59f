// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/cell_sides.hpp>
#include <fretwork/tiling/dual/edits.hpp>

#include <algorithm>
#include <tuple>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;

constexpr double kShort = 0.4;  // share of the wanted side, or of the adjacent tiles' mean side if smaller
// Factor on the smallest side allowed, because sides change a little afterwards.
constexpr double kMargin = 1.05;

/// A side that is too short. It is on the rim if only one tile has it.
struct ShortSide {
    double length;
    DualVertexIndex from;
    DualVertexIndex to;
    bool is_on_rim;
};

class Collapser {
  public:
    Collapser(Dual& dual, const SizeField& field, double smallest_side, const base::Control& control)
        : dual_(dual),
          field_(field),
          least_(kMargin * smallest_side),
          control_(control),
          cells_of_(dual.vertices.size()) {
        for (std::size_t c = 0; c < dual.cells.size(); ++c) {
            for (const DualVertexIndex vertex : dual.cells[c]) cells_of_[vertex].push_back(c);
        }
    }

    int run() {
        int count = 0;
        for (const ShortSide& side : short_sides()) count += collapse(side) ? 1 : 0;
        return count;
    }

  private:
    [[nodiscard]] const DualVertex& vertex(DualVertexIndex v) const { return dual_.vertices[v]; }

    [[nodiscard]] std::vector<ShortSide> short_sides() const {
        std::vector<ShortSide> result;
        const auto sides = sides_of_cells(dual_, control_);
        for_each_side(sides, control_, [&](std::span<const CellSide> same) {
            const auto [from, to] = same.front().ends();
            const Point2 a = vertex(from).place;
            const Point2 b = vertex(to).place;
            const double usual = std::min(mean_side_beside(dual_, same), field_.at(between(a, b, 0.5)));
            if (distance(a, b) < std::max(kShort * usual, least_))
                result.push_back({distance(a, b), from, to, same.size() == 1});
        });
        std::ranges::sort(result, {}, [](const ShortSide& s) { return std::tuple(s.length, s.from, s.to); });
        return result;
    }

    /// True if the side may be collapsed. Two vertices of the rim may be merged only along the rim, and
    /// corners of the outline stay.
    [[nodiscard]] bool is_allowed(const ShortSide& side) const {
        const DualVertex& a = vertex(side.from);
        const DualVertex& b = vertex(side.to);
        if (a.loop.is_valid() && b.loop.is_valid() && !side.is_on_rim) return false;
        if (a.is_fixed && b.is_fixed) return false;
        int with_both = 0;
        for (const std::size_t cell : cells_of_[side.from]) {
            const auto& vertices = dual_.cells[cell];
            if (std::ranges::count(vertices, side.to) == 0) continue;
            if (vertices.size() <= 3) return false;
            ++with_both;
        }
        return with_both == (side.is_on_rim ? 1 : 2);
    }

    bool collapse(ShortSide side) {
        auto& from = cells_of_[side.from];
        auto& to = cells_of_[side.to];
        if (from.empty() || to.empty() || !is_allowed(side)) return false;
        // Of the two ends, a corner stays, or else a vertex on the rim, preferably a vertex at which another
        // side ends.
        const auto rank = [&](DualVertexIndex v) {
            if (!vertex(v).loop.is_valid()) return 0;
            return vertex(v).is_fixed ? 3 : vertex(v).divides_side ? 1 : 2;
        };
        const bool keeps_to = rank(side.to) > rank(side.from);
        const DualVertexIndex kept = keeps_to ? side.to : side.from;
        const DualVertexIndex gone = keeps_to ? side.from : side.to;
        if (rank(kept) == rank(gone) && rank(kept) == 0) {
            DualVertex& middle = dual_.vertices[kept];
            middle.place = between(vertex(kept).place, vertex(gone).place, 0.5);
        }
        for (const std::size_t c : cells_of_[gone]) {
            Cell& cell = dual_.cells[c];
            if (std::ranges::count(cell, kept) > 0) {
                std::erase(cell, gone);
            } else {
                std::ranges::replace(cell, gone, kept);
                cells_of_[kept].push_back(c);
            }
        }
        cells_of_[gone].clear();
        return true;
    }

    Dual& dual_;
    const SizeField& field_;
    double least_;  // m
    const base::Control& control_;
    base::IndexVector<DualVertexIndex, std::vector<std::size_t>> cells_of_;
};

}  // namespace

int collapse_short_sides(Dual& dual, const SizeField& field, double smallest_side,
                         const base::Control& control) {
    return Collapser(dual, field, smallest_side, control).run();
}

}  // namespace fretwork::tiling::detail
