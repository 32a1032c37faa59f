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

/// The pattern repeated around a polygon: a graph without coordinates, the same for every polygon of as many
/// sides.
///
/// Nodes: first *all* interface nodes, side by side, on each side from v1 to v2 (so that interface node k of
/// side t is number t * per_side + k, used or not); then the used inner nodes, by layout node and sector.
/// Radial nodes of neighbouring sectors are one node; the center is one node for all sectors.
struct Fan {
    struct Node {
        LayoutNodeIndex layout_node;  ///< never one on v0 v2: that is its partner of the next sector
        int sector = 0;
        friend bool operator==(const Node&, const Node&) = default;
    };
    int sides = 0;
    int interface_node_count = 0;  ///< in all: sides times the interface nodes of a side
    base::IndexVector<FanNodeIndex, Node> nodes{};
    std::vector<std::array<FanNodeIndex, 2>> edges{};  ///< each once, sorted, smaller node first
};

/// The sectors of the reference fan: angles, valence, connectivity and lengths are those in the regular
/// hexagon, as in the paper.
inline constexpr int kReferenceSides = 6;

/// Repeat a pattern around a polygon of `sides` sides. Throws InputError unless sides >= 3.
Fan make_fan(const NodeLayout& layout, const Pattern& pattern, int sides);

/// Where the nodes of a fan lie in a convex polygon: sector t is the triangle of the polygon's area centroid,
/// vertex t and vertex t + 1, and a node keeps its barycentric coordinates in it. Paper, Section 4.1. Throws
/// GeometryError if the polygon is not convex and counterclockwise; InputError if it has another number of
/// sides.
base::IndexVector<FanNodeIndex, geometry::Point2> place_fan(const NodeLayout& layout, const Fan& fan,
                                                            const geometry::Polygon& polygon);

}  // namespace fretwork::pattern
