// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/results/result_file.hpp>
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

/// The nodes of a result of the assembly of joined tiles.
std::vector<mechanics::Result::Node> result_nodes(const Surface& surface,
                                                  const mechanics::Assembly& assembly);

/// The first of a tile's elements in the assembly of joined tiles, where those of beams come before.
std::size_t first_element(const mechanics::Assembly& assembly, std::span<const TileStart> starts,
                          tiling::TileIndex tile);

/// The inner nodes of a tile: from one node of the surface to before another.
struct InnerNodes {
    std::size_t first = 0;
    std::size_t end = 0;
};
/// Of the rows of all nodes, those of a tile: of its interface nodes, then of its inner ones.
mechanics::NodeValues rows_of_tile(const mechanics::NodeValues& rows,
                                   std::span<const tiling::InterfaceIndex> interface_nodes,
                                   const InnerNodes& inner = {});

/// Throws Stopped.
JoinedTiles join_tiles(const Surface& surface, std::span<const BuiltTile> tiles,
                       const base::Control& control);

/// The row of a node among those of its tile: interface nodes, then inner nodes.
class TileRows {
  public:
    struct Surface {
        std::size_t interface_nodes = 0;   ///< of the surface: its first nodes
        std::size_t first_inner_node = 0;  ///< of the tile
    };
    TileRows(const std::vector<tiling::InterfaceIndex>& interface_nodes, const Surface& surface)
        : interface_(interface_nodes), surface_(surface) {}

    Eigen::Index operator()(mechanics::NodeIndex node) const {
        const std::size_t n = node;
        if (n >= surface_.interface_nodes)
            return static_cast<Eigen::Index>(interface_.size() + n - surface_.first_inner_node);
        Eigen::Index row = 0;
        while (interface_[static_cast<std::size_t>(row)].value != node.value) ++row;
        return row;
    }

  private:
    const std::vector<tiling::InterfaceIndex>& interface_;
    Surface surface_;
};

/// The elements of a tile that is built again, if it has the same nodes as before and as many elements, none
/// of them beams: then they can take the place of the old ones.
std::optional<mechanics::Elements> replacement(std::span<const TileStart> starts, const Surface& surface,
                                               tiling::TileIndex tile, const BuiltTile& built);

}  // namespace fretwork::simulation::detail
