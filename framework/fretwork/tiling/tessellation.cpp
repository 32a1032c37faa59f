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

}  // namespace fretwork::tiling
