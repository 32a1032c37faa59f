// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/tessellation.hpp>

#include <map>
#include <utility>

namespace fretwork::tiling {
namespace {

/// The sides that a single tile has, by their first vertex. If two stretches of the rim touch at a vertex,
/// two sides begin there.
std::multimap<VertexIndex, RimSide> unshared_sides(const Tessellation& tessellation) {
    std::map<std::pair<VertexIndex, VertexIndex>, RimSide> sides;
    for (const TileIndex t : tessellation.tiles.indices()) {
        const Tile& tile = tessellation.tiles[t];
        const std::size_t count = tile.vertices.size();
        const std::size_t nodes_a_side = tile.interface_nodes.size() / count;
        for (std::size_t s = 0; s < count; ++s) {
            const VertexIndex from = tile.vertices[s];
            const VertexIndex to = tile.vertices[(s + 1) % count];
            if (sides.erase({to, from}) > 0) continue;  // a neighbour has the side, too
            const auto first = tile.interface_nodes.begin() + s * nodes_a_side;
            sides[{from, to}] = {t, from, to, {first, first + nodes_a_side}};
        }
    }
    std::multimap<VertexIndex, RimSide> rim;
    for (auto& [ends, side] : sides) rim.emplace(ends.first, std::move(side));
    return rim;
}

}  // namespace

std::vector<std::vector<RimSide>> rim_sides(const Tessellation& tessellation) {
    auto sides = unshared_sides(tessellation);
    std::vector<std::vector<RimSide>> lines;
    while (!sides.empty()) {
        std::vector<RimSide>& line = lines.emplace_back();
        for (auto side = sides.begin(); side != sides.end(); side = sides.find(line.back().to)) {
            line.push_back(std::move(side->second));
            sides.erase(side);
        }
    }
    return lines;
}

std::vector<std::vector<InterfaceIndex>> rim_loops(const Tessellation& tessellation) {
    std::vector<std::vector<InterfaceIndex>> loops;
    for (const std::vector<RimSide>& line : rim_sides(tessellation)) {
        std::vector<InterfaceIndex>& loop = loops.emplace_back();
        for (const RimSide& side : line) loop.insert(loop.end(), side.nodes.begin(), side.nodes.end());
    }
    return loops;
}

}  // namespace fretwork::tiling
