// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/tessellation.hpp>

#include <map>
#include <utility>

namespace fretwork::tiling {
namespace {

/// A side that only one tile has: where it ends, and its interface nodes.
struct RimSide {
    VertexIndex end;
    std::vector<InterfaceIndex> nodes;
};
/// By the vertex where a side begins. Where two parts of the rim touch in a vertex, two begin there.
using RimSides = std::multimap<VertexIndex, RimSide>;

RimSides rim_sides(const Tessellation& tessellation) {
    std::map<std::pair<VertexIndex, VertexIndex>, RimSide> sides;
    for (const Tile& tile : tessellation.tiles) {
        const std::size_t count = tile.vertices.size();
        const std::size_t nodes_a_side = tile.interface_nodes.size() / count;
        for (std::size_t s = 0; s < count; ++s) {
            const VertexIndex from = tile.vertices[s];
            const VertexIndex to = tile.vertices[(s + 1) % count];
            if (sides.erase({to, from}) > 0) continue;  // its neighbour has the side, too
            const auto first = tile.interface_nodes.begin() + s * nodes_a_side;
            sides[{from, to}] = {to, {first, first + nodes_a_side}};
        }
    }
    RimSides rim;
    for (auto& [ends, side] : sides) rim.emplace(ends.first, std::move(side));
    return rim;
}

}  // namespace

std::vector<std::vector<InterfaceIndex>> rim_loops(const Tessellation& tessellation) {
    RimSides sides = rim_sides(tessellation);
    std::vector<std::vector<InterfaceIndex>> loops;
    while (!sides.empty()) {
        std::vector<InterfaceIndex>& loop = loops.emplace_back();
        for (auto side = sides.begin(); side != sides.end();) {
            loop.insert(loop.end(), side->second.nodes.begin(), side->second.nodes.end());
            const VertexIndex next = side->second.end;
            sides.erase(side);
            side = sides.find(next);
        }
    }
    return loops;
}

}  // namespace fretwork::tiling
