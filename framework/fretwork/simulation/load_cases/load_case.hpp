// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/simulation/load_cases/selection.hpp>

#include <Eigen/Core>

#include <string>
#include <variant>
#include <vector>

namespace fretwork::simulation {

/// Supports and loads of a tessellation, all of them on interface nodes, which every tile model has; or what
/// is to be combined of other load cases; or both.
struct LoadCase {
    struct Support {
        Selection where;
        mechanics::DofSet fixed;
        friend bool operator==(const Support&, const Support&) = default;
    };
    /// Whether each picked node gets the load, or all of them together. Or it is a line load along the rim,
    /// N/m: along a side of the box (NodesAtSide), or the shorter way between the places nearest to two
    /// points (NodesNearest); each node stands for an equal part of its side, as long as it is at rest.
    enum class Amount { Each, Total, PerLength };
    struct Load {
        Selection where;
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m, fixed direction in space
        Amount amount = Amount::Each;
        friend bool operator==(const Load&, const Load&) = default;
    };
    struct PrescribedDisplacement {
        Selection where;
        mechanics::Dof dof = mechanics::Dof::ux;
        double value = 0.0;  ///< m or rad
        friend bool operator==(const PrescribedDisplacement&, const PrescribedDisplacement&) = default;
    };
    /// Spread over interface nodes: each stands for an equal part of each of its tiles. It keeps its
    /// direction, and acts on the area at rest.
    struct AreaLoad {
        struct Tiles {
            std::vector<int> numbers;
            friend bool operator==(const Tiles&, const Tiles&) = default;
        };
        std::variant<Selection, Tiles> where;  ///< nodes with all that they stand for; or some tiles
        Eigen::Vector3d per_area = Eigen::Vector3d::Zero();  ///< N/m2
        friend bool operator==(const AreaLoad&, const AreaLoad&) = default;
    };
    /// Another load case of the same project, and how much of it acts (combination.hpp).
    struct Share {
        std::string load_case;  ///< its name
        double factor = 1.0;
        friend bool operator==(const Share&, const Share&) = default;
    };
    std::string name;
    std::string description;
    std::vector<Support> supports;
    std::vector<Load> loads;
    std::vector<PrescribedDisplacement> prescribed;
    std::vector<AreaLoad> area_loads{};
    std::vector<Share> combines{};
    /// m/s^2. The weight of a tile's beams is shared evenly by its interface nodes, in every model: paper,
    /// Section 7.3.
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
    friend bool operator==(const LoadCase&, const LoadCase&) = default;
};

}  // namespace fretwork::simulation
