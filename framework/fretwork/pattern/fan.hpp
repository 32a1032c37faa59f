// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <array>
#include <vector>

namespace fretwork::pattern {

/// A node of a fan, in the order of Fan::nodes.
using FanNodeIndex = base::Index<struct FanNodeTag>;

/// The pattern repeated around a polygon: a graph without coordinates. All polygons with the same number of
/// sides have the same fan.
///
/// The first nodes are *all* interface nodes, used or not, one side after the other and on each side from v1
/// to v2: with k interface nodes on a side, node i of side t has number t k + i. The used inner nodes follow,
/// by layout node and then by sector. A radial node is shared by the two sectors beside it, and the center by
/// all sectors.
struct Fan {
    /// A node of the fan.
    struct Node {
        /// The node of the layout; never a node on v0 v2, which is a node on v0 v1 of the next sector.
        LayoutNodeIndex layout_node;
        int sector = 0;  ///< the sector, numbered from 0 counterclockwise
        friend bool operator==(const Node&, const Node&) = default;
    };
    int sides = 0;                                     ///< number of sides of the polygon
    int interface_node_count = 0;                      ///< number of interface nodes on all sides together
    base::IndexVector<FanNodeIndex, Node> nodes{};     ///< interface nodes first
    std::vector<std::array<FanNodeIndex, 2>> edges{};  ///< each edge once, smaller node first; sorted
};

/// The number of sectors of the reference fan: filters measure angles, valence, connectivity and lengths in
/// the regular hexagon, as in the paper.
inline constexpr int kReferenceSides = 6;

/// Repeat a pattern around a polygon of `sides` sides. Throws InputError unless there are 3 to
/// geometry::kMostPolygonSides sides.
Fan make_fan(const NodeLayout& layout, const Pattern& pattern, int sides);

/// The positions (m) of the nodes of a fan in a convex polygon. Sector t is the triangle of the polygon's
/// area centroid, vertex t and vertex t + 1. Each node keeps its barycentric coordinates in its sector.
/// Paper, Section 4.1. Throws GeometryError if the polygon is not convex and counterclockwise, InputError if
/// polygon and fan differ in the number of sides.
base::IndexVector<FanNodeIndex, geometry::Point2> place_fan(const NodeLayout& layout, const Fan& fan,
                                                            const geometry::Polygon& polygon);

}  // namespace fretwork::pattern
