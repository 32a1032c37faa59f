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

/// The index of a tile.
using TileIndex = base::Index<struct TileTag>;
/// The index of a vertex.
using VertexIndex = base::Index<struct VertexTag>;
/// The index of an interface node of the tessellation. An interface node has the same number in every model
/// of the surface.
using InterfaceIndex = base::Index<struct InterfaceTag>;

/// A convex polygon of the tessellation. The first vertex of the polygon is vertex 0 and sets the orientation
/// of the tile's pattern. tessellate() chooses vertex 0 so that the first side faces down (against y) as
/// nearly as possible, as in geometry::regular_polygon(). "Down" is adjusted by at most 30 degrees, to a
/// direction that sides of most hexagons face, so that neighbours in a regular region have the same
/// orientation.
struct Tile {
    std::vector<VertexIndex> vertices;  ///< counterclockwise
    /// One side after the other, and on side t from vertex t to t + 1, as in pattern::Fan.
    std::vector<InterfaceIndex> interface_nodes;
    int pattern = -1;  ///< index into Tessellation::patterns; -1: not painted
};

/// A flat surface of polygons, which are painted with patterns or not. Neighbours share interface nodes.
/// tessellate() numbers tiles from left to right by their centroids, and vertices and interface nodes in the
/// order in which the tiles first use them.
struct Tessellation {
    std::string layout;  ///< name of the node layout that defines the interface nodes
    base::IndexVector<VertexIndex, geometry::Point2> vertices;            ///< metres
    base::IndexVector<TileIndex, Tile> tiles;                             ///< counterclockwise polygons
    base::IndexVector<InterfaceIndex, geometry::Point2> interface_nodes;  ///< positions, m
    std::vector<pattern::NamedPattern> patterns;                          ///< the palette in use
};

/// Turn a tile's pattern: vertex 0 moves by `vertices` vertices counterclockwise; a negative number moves it
/// clockwise.
void turn(Tile& tile, int vertices);

/// The pattern of a tile; null if it is not painted.
const pattern::NamedPattern* pattern_of(const Tessellation& tessellation, TileIndex tile);

/// The pattern of a tile. Throws InputError if the tile is not painted.
const pattern::NamedPattern& painted_pattern_of(const Tessellation& tessellation, TileIndex tile);

/// The polygon of a tile.
geometry::Polygon tile_polygon(const Tessellation& tessellation, TileIndex tile);

/// The indices in Tessellation::patterns of the patterns that tiles have, ascending.
std::vector<std::size_t> used_patterns(const Tessellation& tessellation);

/// The mean, over all tiles, of the mean length of a tile's sides, m.
double mean_tile_side(const Tessellation& tessellation);

/// A side that belongs to one tile only, in the direction of the tile's polygon: the surface lies on its
/// left.
struct RimSide {
    TileIndex tile;                     ///< the only tile at this side
    VertexIndex from;                   ///< first vertex of the side, counterclockwise
    VertexIndex to;                     ///< second vertex of the side
    std::vector<InterfaceIndex> nodes;  ///< interface nodes on the side, in the direction of the side
};
/// A side that two tiles share.
struct SharedSide {
    std::array<TileIndex, 2> tiles;     ///< the two tiles, ascending
    VertexIndex from;                   ///< first vertex of the side, counterclockwise around the second tile
    VertexIndex to;                     ///< second vertex of the side
    std::vector<InterfaceIndex> nodes;  ///< interface nodes on the side, from `from` to `to`
};
/// The sides that two tiles share, in the order of their second tiles.
std::vector<SharedSide> shared_sides(const Tessellation& tessellation);

/// The closed lines of the rim, each as a list of sides: the outer boundary of each part, and each hole. The
/// order of the lines follows their smallest vertices. Lines that touch in a vertex may form one line.
std::vector<std::vector<RimSide>> rim_sides(const Tessellation& tessellation);
/// The interface nodes along each closed line of the rim.
std::vector<std::vector<InterfaceIndex>> rim_loops(const Tessellation& tessellation);

/// Check that a tessellation, for example one from a file, is valid:
/// - it names the layout `layout`, has a tile, and its indices are in range;
/// - positions are within the limits of lengths (base::kLengthLimits);
/// - tiles are counterclockwise and convex, up to rounding (geometry::is_nearly_convex());
/// - at most two tiles share a side, in opposite directions and with the same interface nodes;
/// - each interface node lies on its side at a place of the layout, and on no other side;
/// - each pattern of a tile exists, is listed once, and is a pattern of the layout;
/// - each vertex and each interface node belongs to a tile.
///
/// Throws InputError or GeometryError that names the tile, vertex, interface node, pattern or layout.
void validate(const Tessellation& tessellation, const pattern::NodeLayout& layout);

}  // namespace fretwork::tiling
