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

/// Three components in the surface's axes; one without a value is free.
using FreeVector = std::array<std::optional<double>, 3>;

/// A wanted displacement or position for each of these interface nodes.
struct NodesGoal {
    /// What is given of the nodes.
    enum class Quantity { Displacements, Positions };
    std::vector<int> nodes;                       ///< numbers of interface nodes
    Quantity quantity = Quantity::Displacements;  ///< what is given
    std::vector<FreeVector> values;               ///< m
    friend bool operator==(const NodesGoal&, const NodesGoal&) = default;
};

/// Wanted displacements of selected nodes, as expressions of their coordinates x and y at rest (m).
struct FormulaGoal {
    simulation::Selection where;  ///< which nodes
    std::array<std::optional<std::string>, 3>
        displacement;  ///< m; a component without an expression is free; a number is an expression, too
    friend bool operator==(const FormulaGoal&, const FormulaGoal&) = default;
};

/// Selected nodes shall lie on a surface in space. They may slide along it: only distances count.
struct MeshGoal {
    simulation::Selection where;  ///< which nodes
    std::filesystem::path mesh;   ///< OBJ, PLY or OFF, metres, in the axes of the project
    friend bool operator==(const MeshGoal&, const MeshGoal&) = default;
};

/// Selected nodes shall turn by this rotation vector (rad).
struct RotationGoal {
    simulation::Selection where;  ///< which nodes
    FreeVector rotation;          ///< rad
    friend bool operator==(const RotationGoal&, const RotationGoal&) = default;
};

/// The range of the weights of goals: a goal with a thousandth of another one's weight hardly counts.
inline constexpr double kLeastWeight = 1e-6;
inline constexpr double kMostWeight = 1e6;  ///< the upper end of the range

/// Where some nodes shall go.
struct Goal {
    std::variant<NodesGoal, FormulaGoal, MeshGoal, RotationGoal> what;  ///< one of four kinds
    double weight = 1.0;      ///< weight of the squared distance of each of its nodes, in the range above
    std::string load_case{};  ///< the load case under which the goal applies; "": the design's load case
    /// Throws InputError for a weight out of its range, and a rotation vector longer than pi.
    void validate() const;
    friend bool operator==(const Goal&, const Goal&) = default;
};

/// The shape that a designed surface shall take, under one load case or several.
struct Target {
    std::string name;         ///< for reports
    std::string description;  ///< a sentence
    std::vector<Goal> goals;  ///< at least one
    friend bool operator==(const Target&, const Target&) = default;
};

}  // namespace fretwork::design
