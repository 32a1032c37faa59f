// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/results/result_file.hpp>
#include <fretwork/simulation/detail/tile_builder.hpp>

#include <optional>
#include <vector>

namespace fretwork::simulation::detail {

/// The indices of a tile's first inner node, beam and element among those of all tiles.
struct TileStart {
    std::size_t inner_node = 0;
    std::size_t beam = 0;
    std::size_t element = 0;
};

/// The tiles of a surface as one structure. Nodes: the interface nodes with their own ids, then the inner
/// nodes of the tiles, tile by tile.
struct JoinedTiles {
    reduction::StructureParts parts;
    std::vector<TileStart> starts;  ///< start of each tile; one further entry has the ends of the last tile
};

/// The nodes of a result of the assembly of joined tiles.
std::vector<mechanics::Result::Node> result_nodes(const Surface& surface,
                                                  const mechanics::Assembly& assembly);

/// The index of a tile's first element in the assembly of joined tiles. The elements of beams come first.
std::size_t first_element(const mechanics::Assembly& assembly, std::span<const TileStart> starts,
                          tiling::TileIndex tile);

/// The range of a tile's inner nodes among all nodes of the surface.
struct InnerNodes {
    std::size_t first = 0;
    std::size_t end = 0;  ///< index after the last
};
/// The rows of a tile's nodes, taken from the rows of all nodes: its interface nodes, then its inner nodes.
mechanics::NodeValues rows_of_tile(const mechanics::NodeValues& rows,
                                   std::span<const tiling::InterfaceIndex> interface_nodes,
                                   const InnerNodes& inner = {});

/// Join tiles to one structure. Throws Stopped.
JoinedTiles join_tiles(const Surface& surface, std::span<const BuiltTile> tiles,
                       const base::Control& control);

/// Finds the row of a node among the rows of its tile: interface nodes, then inner nodes. Pre: the tile has
/// the node.
class TileRows {
  public:
    struct Surface {
        std::size_t interface_nodes = 0;   ///< number in the surface; they come first
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

/// The elements of a rebuilt tile, for the places of the old ones. None if the old or the new tile has inner
/// nodes or beams, or if the number of elements differs.
std::optional<mechanics::Elements> replacement(std::span<const TileStart> starts, const Surface& surface,
                                               tiling::TileIndex tile, const BuiltTile& built);

}  // namespace fretwork::simulation::detail
