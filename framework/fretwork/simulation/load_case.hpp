// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace fretwork::simulation {

/// Which interface nodes a support or a load is on.
struct NodesById {
    std::vector<int> ids;
};
struct NodesInBox {
    std::array<double, 4> box{};
};  ///< xmin ymin xmax ymax, metres, rim included
struct NodesNearest {
    std::vector<pattern::Point2> points;
};  ///< the interface node nearest to each point
enum class Side { Left, Right, Bottom, Top };
struct NodesAtSide {
    Side side = Side::Left;
};  ///< the rim nodes nearest to that side of the bounding box
using Selection = std::variant<NodesById, NodesInBox, NodesNearest, NodesAtSide>;

/// What holds a tessellation and what acts on it. All of it is on interface nodes, which every model of it
/// shares.
struct LoadCase {
    struct Hold {
        Selection where;
        mechanics::DofSet fixed;
    };
    struct Load {
        Selection where;
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N, on each node that is picked
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m, on each
    };
    struct Prescribe {
        Selection where;
        mechanics::Dof dof;
        double value;
    };
    std::string name;
    std::string description;
    std::vector<Hold> supports;
    std::vector<Load> loads;
    std::vector<Prescribe> prescribed;
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< m/s^2; the full model's own weight, lumped on
                                                        ///< interface nodes in every model
};

/// Read a load case file. Throws InputError with file and JSON pointer.
LoadCase read_load_case(const std::filesystem::path& path);

/// The interface nodes of a selection, ascending. Throws InputError if there is none, or an id is out of
/// range.
std::vector<tiling::InterfaceIndex> select(const Selection& selection,
                                           const tiling::Tessellation& tessellation);

}  // namespace fretwork::simulation
