// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>
#include <set>

namespace fretwork::tiling {

void turn(Tile& tile, int vertices) {
    const auto sides = std::ssize(tile.vertices);
    const auto by = (vertices % sides + sides) % sides;
    const auto interface_nodes_a_side = std::ssize(tile.interface_nodes) / sides;
    std::ranges::rotate(tile.vertices, tile.vertices.begin() + by);
    std::ranges::rotate(tile.interface_nodes, tile.interface_nodes.begin() + by * interface_nodes_a_side);
}

const pattern::NamedPattern* pattern_of(const Tessellation& tessellation, TileIndex tile) {
    const int place = tessellation.tiles[tile].pattern;
    return place < 0 ? nullptr : &tessellation.patterns[place];
}

const pattern::NamedPattern& painted_pattern_of(const Tessellation& tessellation, TileIndex tile) {
    const int place = tessellation.tiles[tile].pattern;
    if (place < 0 || place >= static_cast<int>(tessellation.patterns.size()))
        throw base::InputError("tile " + std::to_string(tile.value) + " is not painted with a pattern");
    return tessellation.patterns[place];
}

geometry::Polygon tile_polygon(const Tessellation& tessellation, TileIndex tile) {
    geometry::Polygon polygon;
    for (const VertexIndex vertex : tessellation.tiles[tile].vertices) {
        polygon.push_back(tessellation.vertices[vertex]);
    }
    return polygon;
}

std::vector<std::size_t> used_patterns(const Tessellation& tessellation) {
    std::set<std::size_t> used;
    for (const Tile& tile : tessellation.tiles) {
        if (tile.pattern >= 0) used.insert(tile.pattern);
    }
    return {used.begin(), used.end()};
}

double mean_tile_side(const Tessellation& tessellation) {
    double sum = 0.0;
    for (std::size_t i = 0; i < tessellation.tiles.size(); ++i) {
        sum += geometry::mean_side(tile_polygon(tessellation, TileIndex(i)));
    }
    return sum / static_cast<double>(tessellation.tiles.size());
}

}  // namespace fretwork::tiling
