// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/simulation/load_cases/selection.hpp>

#include <Eigen/Core>

#include <string>
#include <variant>
#include <vector>

namespace fretwork::simulation {

/// Supports and loads of a surface, and the other load cases to combine. All supports and loads are on
/// interface nodes, because every tile model has these.
struct LoadCase {
    /// Nodes that are held.
    struct Support {
        Selection where;          ///< which nodes
        mechanics::DofSet fixed;  ///< components that stay zero
        friend bool operator==(const Support&, const Support&) = default;
    };
    /// The meaning of a load's vectors. Each: every selected node gets them. Total: all selected nodes share
    /// them. PerLength: they are a line load along the rim, N/m, either along a side of the bounding box
    /// (NodesAtSide) or along the shorter way between the places nearest to two points (NodesNearest). Each
    /// node of a tile's side represents an equal length of it, measured at rest.
    enum class Amount { Each, Total, PerLength };
    /// Nodes that are loaded.
    struct Load {
        Selection where;                                   ///< which nodes
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m, fixed direction in space
        Amount amount = Amount::Each;                      ///< each node, or all together
        friend bool operator==(const Load&, const Load&) = default;
    };
    /// Nodes that are given a displacement.
    struct PrescribedDisplacement {
        Selection where;                          ///< which nodes
        mechanics::Dof dof = mechanics::Dof::ux;  ///< which component
        double value = 0.0;                       ///< m or rad
        friend bool operator==(const PrescribedDisplacement&, const PrescribedDisplacement&) = default;
    };
    /// A load per area. Each interface node represents an equal share of the area of each of its tiles. The
    /// load keeps its direction and acts on the area at rest.
    struct AreaLoad {
        /// Whole tiles, by number.
        struct Tiles {
            std::vector<int> numbers;  ///< from 0
            friend bool operator==(const Tiles&, const Tiles&) = default;
        };
        std::variant<Selection, Tiles> where;  ///< nodes with the area that they represent, or tiles
        Eigen::Vector3d per_area = Eigen::Vector3d::Zero();  ///< N/m2
        friend bool operator==(const AreaLoad&, const AreaLoad&) = default;
    };
    /// Another load case of the same project, and the factor on it (combination.hpp).
    struct Share {
        std::string load_case;  ///< its name
        double factor = 1.0;    ///< on all its loads
        friend bool operator==(const Share&, const Share&) = default;
    };
    std::string name;                                ///< as commands name it
    std::string description;                         ///< a sentence
    std::vector<Support> supports;                   ///< what holds
    std::vector<Load> loads;                         ///< forces and moments on nodes
    std::vector<PrescribedDisplacement> prescribed;  ///< displacements that nodes are given
    std::vector<AreaLoad> area_loads{};              ///< N/m^2
    std::vector<Share> combines{};                   ///< other load cases times factors
    /// m/s^2. In every model, the interface nodes of a tile share the weight of its beams equally: paper,
    /// Section 7.3.
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
    friend bool operator==(const LoadCase&, const LoadCase&) = default;
};

}  // namespace fretwork::simulation
