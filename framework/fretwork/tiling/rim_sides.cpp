// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/tessellation.hpp>

#include <map>
#include <utility>

namespace fretwork::tiling {
namespace {

/// All sides: those that two tiles share, and those of one tile alone (the rim), by the vertex at which they
/// begin. Where two parts of the rim touch in a vertex, two sides of the rim begin there.
struct Sides {
    std::vector<SharedSide> shared;
    std::multimap<VertexIndex, RimSide> rim;
};

Sides sides_of(const Tessellation& tessellation) {
    Sides all;
    std::map<std::pair<VertexIndex, VertexIndex>, RimSide> alone;
    for (const TileIndex t : tessellation.tiles.indices()) {
        const Tile& tile = tessellation.tiles[t];
        const std::size_t count = tile.vertices.size();
        const std::size_t nodes_a_side = tile.interface_nodes.size() / count;
        for (std::size_t s = 0; s < count; ++s) {
            const VertexIndex from = tile.vertices[s];
            const VertexIndex to = tile.vertices[(s + 1) % count];
            const auto first = tile.interface_nodes.begin() + s * nodes_a_side;
            RimSide side{t, from, to, {first, first + nodes_a_side}};
            if (const auto other = alone.find({to, from}); other != alone.end()) {
                all.shared.push_back({{other->second.tile, t}, from, to, std::move(side.nodes)});
                alone.erase(other);
            } else {
                alone[{from, to}] = std::move(side);
            }
        }
    }
    for (auto& [ends, side] : alone) all.rim.emplace(ends.first, std::move(side));
    return all;
}

}  // namespace

std::vector<SharedSide> shared_sides(const Tessellation& tessellation) {
    return sides_of(tessellation).shared;
}

std::vector<std::vector<RimSide>> rim_sides(const Tessellation& tessellation) {
    auto sides = sides_of(tessellation).rim;
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
