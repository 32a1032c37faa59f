// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/index_vector.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <array>
#include <string>
#include <vector>

namespace fretwork::tiling {

using TileIndex = base::Index<struct TileTag>;
using VertexIndex = base::Index<struct VertexTag>;
/// An interface node of the tessellation: the same number in every model of it.
using InterfaceIndex = base::Index<struct InterfaceTag>;

/// A convex polygon of the tessellation. Its first vertex is vertex 0, and so the orientation of its pattern:
/// the first side faces down (against y), as in geometry::regular_polygon, as nearly as a direction within 30
/// degrees of that allows which the sides of most hexagons face; so neighbours in a regular region have the
/// same orientation.
struct Tile {
    std::vector<VertexIndex> vertices;  ///< counterclockwise
    std::vector<InterfaceIndex>
        interface_nodes;  ///< side by side, on each side from vertex t to t + 1, as in pattern::Fan
    int pattern = -1;     ///< index into Tessellation::patterns; -1: not painted
};

/// A flat surface of polygons that share interface nodes, each painted with a pattern. `tessellate` numbers
/// tiles from left to right by their centroids, and vertices and interface nodes as the tiles come to them.
struct Tessellation {
    std::string layout;  ///< name of the node layout whose interface nodes it has
    base::IndexVector<VertexIndex, geometry::Point2> vertices;  ///< metres
    base::IndexVector<TileIndex, Tile> tiles;
    base::IndexVector<InterfaceIndex, geometry::Point2> interface_nodes;  ///< places, metres
    std::vector<pattern::NamedPattern> patterns;                          ///< the palette in use
};

/// Turn a tile's pattern: its first vertex moves on by `vertices`, counterclockwise, back if below zero.
void turn(Tile& tile, int vertices);

/// The pattern of a tile; null if it is not painted.
const pattern::NamedPattern* pattern_of(const Tessellation& tessellation, TileIndex tile);

/// The polygon of a tile.
geometry::Polygon tile_polygon(const Tessellation& tessellation, TileIndex tile);

/// The places in Tessellation::patterns of those that a tile has, ascending.
std::vector<std::size_t> used_patterns(const Tessellation& tessellation);

/// The mean over the tiles of the mean length of a tile's sides, m.
double mean_tile_side(const Tessellation& tessellation);

/// A side that only one tile has, in the direction of that tile's polygon: the surface lies on the left.
struct RimSide {
    TileIndex tile;
    VertexIndex from;
    VertexIndex to;
    std::vector<InterfaceIndex> nodes;  ///< between the two
};
/// The closed lines of the rim, side after side: the outer boundary and each hole by itself.
std::vector<std::vector<RimSide>> rim_sides(const Tessellation& tessellation);
/// The interface nodes along each of these lines.
std::vector<std::vector<InterfaceIndex>> rim_loops(const Tessellation& tessellation);

/// Check what every tessellation must obey, such as one that was read from a file: its layout's name, indices
/// in range, finite places, tiles that are convex and counterclockwise (decided exactly), sides that two
/// tiles at most share, in opposite directions, with the same interface nodes, interface nodes that lie on
/// their side at the layout's places and on no other side, patterns that are there, once each, and are
/// patterns of the layout, and nothing that no tile has (but patterns). Throws InputError or GeometryError
/// that names the tile.
void validate(const Tessellation& tessellation, const pattern::NodeLayout& layout);

}  // namespace fretwork::tiling
