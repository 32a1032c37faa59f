// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/tiling/tessellation.hpp>

namespace fretwork::tiling {

pattern::Polygon tile_polygon(const Tessellation& tessellation, TileIndex tile) {
    pattern::Polygon polygon;
    for (const VertexIndex vertex : tessellation.tiles[static_cast<std::size_t>(tile.value)].vertices) {
        polygon.push_back(tessellation.vertices[static_cast<std::size_t>(vertex.value)]);
    }
    return polygon;
}

double mean_tile_side(const Tessellation& tessellation) {
    double sum = 0.0;
    for (std::size_t i = 0; i < tessellation.tiles.size(); ++i) {
        sum += pattern::mean_side(tile_polygon(tessellation, TileIndex(i)));
    }
    return sum / static_cast<double>(tessellation.tiles.size());
}

}  // namespace fretwork::tiling
