// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/selection.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace fretwork::design {

/// A vector in the surface's axes. A component without a value is free.
using FreeVector = std::array<std::optional<double>, 3>;

/// Wanted displacements or positions of listed interface nodes.
struct NodesGoal {
    /// The kind of the wanted values.
    enum class Quantity { Displacements, Positions };
    std::vector<int> nodes;                       ///< numbers of interface nodes
    Quantity quantity = Quantity::Displacements;  ///< kind of `values`
    std::vector<FreeVector> values;               ///< wanted values, one for each node, m
    friend bool operator==(const NodesGoal&, const NodesGoal&) = default;
};

/// Wanted displacements of selected nodes, as expressions of the nodes' coordinates at rest: x and y (m), and
/// u and v (0 to 1 across the surface).
struct FormulaGoal {
    simulation::Selection where;  ///< the nodes
    /// Expressions or numbers, m; a component without a value is free.
    std::array<std::optional<std::string>, 3> displacement;
    friend bool operator==(const FormulaGoal&, const FormulaGoal&) = default;
};

/// A mesh in space on which selected nodes shall lie. Nodes may slide along the mesh: only their distances
/// from it count.
struct MeshGoal {
    simulation::Selection where;  ///< the nodes
    /// OBJ, PLY or OFF file with coordinates in metres, in the surface's axes.
    std::filesystem::path mesh;
    friend bool operator==(const MeshGoal&, const MeshGoal&) = default;
};

/// A wanted rotation vector of selected nodes. A rotation counts as the displacement that it causes at a
/// distance of one mean tile side.
struct RotationGoal {
    simulation::Selection where;  ///< the nodes
    FreeVector rotation;          ///< wanted rotation vector, rad
    friend bool operator==(const RotationGoal&, const RotationGoal&) = default;
};

/// The smallest weight of a goal. A goal has hardly any effect below a thousandth of another goal's weight.
inline constexpr double kLeastWeight = 1e-6;
inline constexpr double kMostWeight = 1e6;  ///< largest weight of a goal

/// A goal for some nodes under one load case.
struct Goal {
    /// The wanted values.
    std::variant<NodesGoal, FormulaGoal, MeshGoal, RotationGoal> what;
    double weight = 1.0;  ///< weight of each node's squared distance, from kLeastWeight to kMostWeight
    /// Name of the goal's load case; "": the load case of the design.
    std::string load_case{};
    /// Throws InputError if the weight is out of range, if a rotation vector is longer than pi, or if a
    /// NodesGoal has a number that is not finite, or not one value for each node.
    void validate() const;
    friend bool operator==(const Goal&, const Goal&) = default;
};

/// The shape that a designed surface shall take, under one load case or several.
struct Target {
    std::string name;         ///< name in reports
    std::string description;  ///< description in one sentence
    std::vector<Goal> goals;  ///< goals, at least one
    friend bool operator==(const Target&, const Target&) = default;
};

}  // namespace fretwork::design
