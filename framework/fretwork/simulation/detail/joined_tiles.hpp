// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/detail/tile_builder.hpp>

#include <optional>
#include <vector>

namespace fretwork::simulation::detail {

/// Where a tile's own nodes, beams and elements begin among those of all tiles.
struct TileStart {
    std::size_t inner_node = 0;
    std::size_t beam = 0;
    std::size_t element = 0;
};

/// The tiles of a surface as one structure. Nodes: the interface nodes with their own ids, then the inner
/// nodes of the tiles, tile by tile.
struct JoinedTiles {
    reduction::StructureParts parts;
    std::vector<TileStart> starts;  ///< of each tile, and behind the last
};

/// Throws Stopped.
JoinedTiles join_tiles(const Surface& surface, std::span<const BuiltTile> tiles,
                       const base::Control& control);

/// The elements of a tile that is built again, if it has the same nodes as before and as many elements, none
/// of them beams: then they can take the place of the old ones.
std::optional<mechanics::Elements> replacement(std::span<const TileStart> starts, const Surface& surface,
                                               tiling::TileIndex tile, const BuiltTile& built);

}  // namespace fretwork::simulation::detail
