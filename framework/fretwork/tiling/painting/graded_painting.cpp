// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/tiling/painting/graded_painting.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace fretwork::tiling {
namespace {

/// For each tile of a list, the positions in the list of the tiles that share an interface node with it.
std::vector<std::vector<std::size_t>> neighbours_of(const Tessellation& tessellation,
                                                    std::span<const TileIndex> tiles) {
    std::vector<std::vector<std::size_t>> neighbours(tiles.size());
    std::map<int, std::size_t> first_at;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        for (const InterfaceIndex node : tessellation.tiles[tiles[i]].interface_nodes) {
            const auto [known, is_new] = first_at.try_emplace(node.value, i);
            const std::size_t other = known->second;
            if (is_new || std::ranges::find(neighbours[i], other) != neighbours[i].end()) continue;
            neighbours[i].push_back(other);
            neighbours[other].push_back(i);
        }
    }
    return neighbours;
}

std::size_t nearest(std::span<const GradedPattern> patterns, double wanted) {
    const auto distance = [&](const GradedPattern& graded) { return std::abs(graded.value - wanted); };
    return std::ranges::min_element(patterns, {}, distance) - patterns.begin();
}

}  // namespace

Painting graded_painting(const Tessellation& tessellation, std::span<const TileIndex> tiles,
                         std::span<const GradedPattern> patterns, std::span<const double> wanted,
                         Dithering dithering) {
    if (patterns.empty()) throw base::InputError("there is no pattern to paint with");
    if (wanted.size() != tiles.size()) throw base::InputError("there is not one value for each tile");
    const auto [low, high] = std::ranges::minmax_element(patterns, {}, &GradedPattern::value);
    const auto neighbours = neighbours_of(tessellation, tiles);
    Painting painting;
    for (const GradedPattern& graded : patterns) painting.patterns.push_back(graded.pattern);
    std::vector<double> missed(tiles.size(), 0.0);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        // An error beyond the range of the patterns is not passed on, because it could never be compensated.
        const double reachable = std::clamp(wanted[i], low->value, high->value) + missed[i];
        const std::size_t chosen = nearest(patterns, reachable);
        painting.tiles.push_back(static_cast<int>(chosen));
        if (dithering == Dithering::None) continue;
        const double rest = reachable - patterns[chosen].value;
        std::vector<std::size_t> later;
        std::ranges::copy_if(neighbours[i], std::back_inserter(later),
                             [&](std::size_t other) { return other > i; });
        if (later.empty() && i + 1 < tiles.size()) later.push_back(i + 1);
        for (const std::size_t other : later) missed[other] += rest / static_cast<double>(later.size());
    }
    return painting;
}

}  // namespace fretwork::tiling
