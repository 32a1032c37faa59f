// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/simulation/load_cases/selection.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace fretwork::simulation {

/// A load case: supports and loads of a surface, and other load cases to combine. Supports and loads act on
/// interface nodes, because every tile model has these.
struct LoadCase {
    /// The source of an entry, for messages. All origins are equal, so that load cases with equal entries are
    /// equal.
    struct Origin {
        /// Position in its list of the file, from 0. None if the entry was not read: messages then give the
        /// position at which load_case_text() writes it.
        std::optional<std::size_t> position{};
        std::string load_case{};  ///< load case from which combined() took the entry; empty: none
        friend bool operator==(const Origin&, const Origin&) { return true; }
    };
    /// The support of selected nodes.
    struct Support {
        Selection where;          ///< the nodes
        mechanics::DofSet fixed;  ///< components that stay zero
        Origin origin{};          ///< source of the entry
        friend bool operator==(const Support&, const Support&) = default;
    };
    /// The meaning of a load's force and moment. Each: every selected node gets both. Total: all selected
    /// nodes share both equally. PerLength: the force is a line load, in N/m, either along a side of the
    /// bounding box (NodesAtSide) or along the shorter way on the rim between the rim's places nearest to two
    /// points (NodesNearest). On a side of the bounding box, tiles' sides that face it, with all of their
    /// nodes at the side, count by their length along it: a straight side bears its whole length, a curved
    /// one only what lies within a tile's side of the box. Each interface node on a tile's side represents an
    /// equal part of its length, measured at rest.
    enum class Amount { Each, Total, PerLength };
    /// A load on selected nodes.
    struct Load {
        Selection where;                                   ///< the nodes
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N; N/m with PerLength
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< moment of fixed direction in space, N m; not
                                                           ///< used with PerLength
        Amount amount = Amount::Each;                      ///< meaning of force and moment
        Origin origin{};                                   ///< source of the entry
        friend bool operator==(const Load&, const Load&) = default;
    };
    /// A given value of a displacement component at selected nodes.
    struct PrescribedDisplacement {
        Selection where;                          ///< the nodes
        mechanics::Dof dof = mechanics::Dof::ux;  ///< the component
        double value = 0.0;                       ///< value, m or rad
        Origin origin{};  ///< source of the entry, which may prescribe several components
        friend bool operator==(const PrescribedDisplacement&, const PrescribedDisplacement&) = default;
    };
    /// A load per area. Each interface node represents an equal share of the area of each of its tiles. The
    /// load keeps its direction and acts on the area at rest.
    struct AreaLoad {
        /// Whole tiles, by number.
        struct Tiles {
            std::vector<int> numbers;  ///< numbers of the tiles, from 0
            friend bool operator==(const Tiles&, const Tiles&) = default;
        };
        /// Nodes, for the area that they represent, or tiles.
        std::variant<Selection, Tiles> where;
        Eigen::Vector3d per_area = Eigen::Vector3d::Zero();  ///< N/m2
        Origin origin{};                                     ///< source of the entry
        friend bool operator==(const AreaLoad&, const AreaLoad&) = default;
    };
    /// Another load case of the same project, with a factor (combination.hpp).
    struct Share {
        std::string load_case;  ///< name of the load case
        double factor = 1.0;    ///< factor on all loads, gravity and prescribed displacements
        friend bool operator==(const Share&, const Share&) = default;
    };
    std::string name;                                ///< name in commands
    std::string description;                         ///< description in one sentence
    std::vector<Support> supports;                   ///< supports of nodes
    std::vector<Load> loads;                         ///< forces and moments on nodes
    std::vector<PrescribedDisplacement> prescribed;  ///< given displacements of nodes
    std::vector<AreaLoad> area_loads{};              ///< loads per area
    std::vector<Share> combines{};                   ///< other load cases, with factors
    /// The acceleration of gravity, m/s^2. In every model, a tile's interface nodes share the weight of its
    /// beams equally (paper, Section 7.3).
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
    friend bool operator==(const LoadCase&, const LoadCase&) = default;
};

}  // namespace fretwork::simulation
