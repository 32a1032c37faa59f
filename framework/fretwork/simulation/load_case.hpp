// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace fretwork::simulation {

/// A side of the bounding box.
enum class Side { Left, Right, Bottom, Top };

/// Interface nodes by their numbers.
struct NodesById {
    std::vector<int> ids;
};
/// All interface nodes in a box, its rim included: xmin ymin xmax ymax in metres.
struct NodesInBox {
    std::array<double, 4> box{};
};
/// The interface node nearest to each of some points.
struct NodesNearest {
    std::vector<pattern::Point2> points;
};
/// The rim nodes along one side: those in a strip of one mean tile side along that side of the bounding box.
struct NodesAtSide {
    Side side = Side::Left;
};
/// Which interface nodes a support or a load is on.
using Selection = std::variant<NodesById, NodesInBox, NodesNearest, NodesAtSide>;

/// What holds a tessellation and what acts on it. All of it is on interface nodes, which every model of it
/// shares.
struct LoadCase {
    struct Hold {
        Selection where;
        mechanics::DofSet fixed;
    };
    /// Whether each picked node gets the load, or all of them together.
    enum class Amount { Each, Total };
    struct Load {
        Selection where;
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m, fixed direction in space
        Amount amount = Amount::Each;
    };
    struct Prescribe {
        Selection where;
        mechanics::Dof dof = mechanics::Dof::ux;
        double value = 0.0;  ///< m or rad
    };
    std::string name;
    std::string description;
    std::vector<Hold> supports;
    std::vector<Load> loads;
    std::vector<Prescribe> prescribed;
    /// m/s^2. The weight of a tile's beams is shared evenly by its interface nodes, in every model: paper,
    /// Section 7.3.
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
};

/// Read a load case file. Throws InputError with file and JSON pointer.
LoadCase read_load_case(const std::filesystem::path& path);

/// The interface nodes of a selection, ascending, each once. Throws InputError if there is none, or an id is
/// out of range.
std::vector<tiling::InterfaceIndex> select_nodes(const Selection& selection,
                                                 const tiling::Tessellation& tessellation);

}  // namespace fretwork::simulation
