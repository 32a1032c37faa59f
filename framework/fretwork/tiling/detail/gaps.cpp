// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/cell_sides.hpp>
#include <fretwork/tiling/detail/gaps.hpp>
#include <fretwork/tiling/detail/plane.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace fretwork::tiling::detail {
namespace {

/// The sides of which cells have one direction only: from their first to their second ends.
std::multimap<int, int> rim_sides(const Dual& dual, const base::Control& control) {
    std::multimap<int, int> rim;
    const auto sides = sides_of_cells(dual, control);
    for_each_side(sides, control, [&](std::span<const CellSide> same) {
        const int from = same.front().from;
        if (std::ranges::all_of(same, [&](const CellSide& side) { return side.from == from; }))
            rim.emplace(from, same.front().to);
    });
    return rim;
}

/// Two ends on one outline of the rim sides before and after a vertex at which the rim touches itself.
struct Wedge {
    int before = -1;
    int after = -1;
};

std::vector<Wedge> wedges_of(const Dual& dual, const base::Control& control) {
    const auto rim = rim_sides(dual, control);
    std::vector<Wedge> wedges;
    for (const auto& [before, tip] : rim) {
        if (rim.count(tip) < 2) continue;
        const auto [first, last] = rim.equal_range(tip);
        for (auto after = first; after != last; ++after) {
            const DualVertex& one = dual.vertices[static_cast<std::size_t>(before)];
            const DualVertex& other = dual.vertices[static_cast<std::size_t>(after->second)];
            const bool is_open = before != after->second && one.loop >= 0 && one.loop == other.loop &&
                                 one.loop != dual.vertices[static_cast<std::size_t>(tip)].loop;
            if (is_open && !(one.is_fixed && other.is_fixed)) wedges.push_back({before, after->second});
        }
    }
    return wedges;
}

/// The dual in which the ends of a wedge are one vertex.
Dual closed(const Dual& dual, Wedge wedge) {
    Dual result = dual;
    if (result.vertices[static_cast<std::size_t>(wedge.after)].is_fixed) std::swap(wedge.before, wedge.after);
    DualVertex& kept = result.vertices[static_cast<std::size_t>(wedge.before)];
    if (!kept.is_fixed)
        kept.place = between(kept.place, result.vertices[static_cast<std::size_t>(wedge.after)].place, 0.5);
    for (std::vector<int>& cell : result.cells)
        std::replace(cell.begin(), cell.end(), wedge.after, wedge.before);
    return result;
}

bool are_sound(const Dual& dual, int vertex) {
    for (std::size_t c = 0; c < dual.cells.size(); ++c) {
        const auto uses = std::count(dual.cells[c].begin(), dual.cells[c].end(), vertex);
        if (uses > 1 || (uses == 1 && !pattern::is_convex(polygon_of(dual, c)))) return false;
    }
    return true;
}

/// Close one wedge, if there is one that can be closed.
bool close_one(Dual& dual, const base::Control& control) {
    for (const Wedge& wedge : wedges_of(dual, control)) {
        control.check();
        Dual result = closed(dual, wedge);
        if (!are_sound(result, wedge.before) || !are_sound(result, wedge.after)) continue;
        dual = std::move(result);
        return true;
    }
    return false;
}

}  // namespace

void close_gaps(Dual& dual, const base::Control& control) {
    while (close_one(dual, control)) {
    }
}

int count_pinches(const Dual& dual, const base::Control& control) {
    const auto rim = rim_sides(dual, control);
    int pinches = 0;
    for (auto side = rim.begin(); side != rim.end(); side = rim.upper_bound(side->first))
        pinches += rim.count(side->first) > 1 ? 1 : 0;
    return pinches;
}

}  // namespace fretwork::tiling::detail
