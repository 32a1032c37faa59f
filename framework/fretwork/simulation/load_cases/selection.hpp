// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellation.hpp>

#include <array>
#include <variant>
#include <vector>

namespace fretwork::simulation {

/// A side of the bounding box of the interface nodes.
enum class Side {
    Left,    ///< side with the smallest x
    Right,   ///< side with the largest x
    Bottom,  ///< side with the smallest y
    Top      ///< side with the largest y
};

/// Interface nodes by their numbers.
struct NodesById {
    std::vector<int> ids;  ///< numbers of interface nodes, from 0
    friend bool operator==(const NodesById&, const NodesById&) = default;
};
/// All interface nodes in a box, its edge included.
struct NodesInBox {
    std::array<double, 4> box{};  ///< xmin, ymin, xmax, ymax, m
    friend bool operator==(const NodesInBox&, const NodesInBox&) = default;
};
/// All interface nodes in a circle, its line included.
struct NodesInCircle {
    geometry::Point2 center;  ///< m
    double radius = 0.0;      ///< above zero, m
    friend bool operator==(const NodesInCircle&, const NodesInCircle&) = default;
};
/// The interface nodes nearest to given points, one for each point.
struct NodesNearest {
    std::vector<geometry::Point2> points;  ///< m
    friend bool operator==(const NodesNearest&, const NodesNearest&) = default;
};
/// The interface nodes on the rim whose distance from a side of the bounding box is at most one mean tile
/// side. Nodes on sides of tiles that face away from this side are left out, such as those on the other line
/// of a narrow strip, or on the near wall of a hole.
struct NodesAtSide {
    Side side = Side::Left;  ///< side of the bounding box of the interface nodes
    friend bool operator==(const NodesAtSide&, const NodesAtSide&) = default;
};
/// A selection of interface nodes for a support or a load.
using Selection = std::variant<NodesById, NodesInBox, NodesInCircle, NodesNearest, NodesAtSide>;

/// The interface nodes of a selection, ascending, each once. Throws InputError if no node lies in a box or a
/// circle, if an id is out of range, if a radius is not above zero, or if a point is beyond the limits of
/// lengths or not a number. Without ids or points, no node is selected.
std::vector<tiling::InterfaceIndex> select_nodes(const Selection& selection,
                                                 const tiling::Tessellation& tessellation);
/// The interface nodes of a selection, as select_nodes(). Throws InputError also if no node is selected.
std::vector<tiling::InterfaceIndex> select_some_nodes(const Selection& selection,
                                                      const tiling::Tessellation& tessellation);

}  // namespace fretwork::simulation
