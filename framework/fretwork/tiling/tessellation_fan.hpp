// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <array>
#include <vector>

namespace fretwork::tiling {

/// A node of a TessellationFan, in the order of TessellationFan::nodes.
using TessellationNodeIndex = base::Index<struct TessellationNodeTag>;

/// The patterns of all tiles as one graph in the plane. Full models and drawings are made from it.
///
/// The first nodes are all interface nodes of the tessellation, with their own numbers, whether a pattern
/// uses them or not. The inner nodes follow, tile by tile, in the order of each tile's fan. Edges are listed
/// tile by tile, in the order of each tile's fan.
struct TessellationFan {
    /// A bar of a tile.
    struct Edge {
        std::array<TessellationNodeIndex, 2> nodes;  ///< its ends
        TileIndex tile;                              ///< whose bar it is
        friend bool operator==(const Edge&, const Edge&) = default;
    };
    int interface_node_count = 0;                                      ///< the first nodes
    base::IndexVector<TessellationNodeIndex, geometry::Point2> nodes;  ///< metres
    std::vector<Edge> edges;                                           ///< tile after tile
    /// For each tile, the graph's nodes of its fan, in the order of pattern::Fan::nodes.
    base::IndexVector<TileIndex, std::vector<TessellationNodeIndex>> tile_nodes;
    /// For each tile, the index of its first edge; one further entry holds the number of edges.
    base::IndexVector<TileIndex, int> first_edge;
};

/// Repeat every tile's pattern around its polygon. Throws InputError if the tessellation is for another
/// layout, or a tile is not painted.
TessellationFan assemble_fans(const pattern::NodeLayout& layout, const Tessellation& tessellation);

}  // namespace fretwork::tiling
