// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <array>
#include <vector>

namespace fretwork::tiling {

/// The index of a node, in the order of TessellationFan::nodes.
using TessellationNodeIndex = base::Index<struct TessellationNodeTag>;

/// The patterns of all tiles as one graph in the plane. Full models and drawings are made from this graph.
///
/// The first nodes are all interface nodes of the tessellation, also those without a bar. They keep their
/// numbers. The inner nodes follow, tile by tile, in the order of each tile's fan. Edges are listed tile by
/// tile, in the order of each tile's fan.
struct TessellationFan {
    /// A bar of a tile.
    struct Edge {
        std::array<TessellationNodeIndex, 2> nodes;  ///< the ends of the bar
        TileIndex tile;                              ///< the tile to which the bar belongs
        friend bool operator==(const Edge&, const Edge&) = default;
    };
    /// Number of interface nodes, which are the first nodes.
    int interface_node_count = 0;
    base::IndexVector<TessellationNodeIndex, geometry::Point2> nodes;  ///< metres
    std::vector<Edge> edges;                                           ///< the bars, tile after tile
    /// For each tile, the nodes of its fan, as nodes of this graph, in the order of pattern::Fan::nodes.
    base::IndexVector<TileIndex, std::vector<TessellationNodeIndex>> tile_nodes;
    /// For each tile, the index of its first edge; one further entry holds the number of edges.
    base::IndexVector<TileIndex, int> first_edge;
};

/// Repeat every tile's pattern around its polygon. Throws InputError if the tessellation is for another
/// layout, or if a tile is not painted or has a wrong number of interface nodes.
TessellationFan assemble_fans(const pattern::NodeLayout& layout, const Tessellation& tessellation);

}  // namespace fretwork::tiling
