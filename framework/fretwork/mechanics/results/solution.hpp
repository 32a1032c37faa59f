// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::mechanics {

/// How a solve ended. Not converged is an outcome, not an error.
enum class Termination { Converged, LimitLoad, Diverged, IterationsSpent };
std::string_view termination_name(Termination termination);

/// How the stability of an equilibrium was decided.
enum class StabilityTest {
    None,           ///< not asked for, or nothing to decide (a linear solution)
    Tangent,        ///< the inertia of the symmetric tangent: necessary and sufficient
    SymmetricPart,  ///< moments of fixed direction on freely turning nodes: the symmetric part's, sufficient
                    ///< only
};
std::string_view stability_test_name(StabilityTest test);

/// Where a path became unstable, and whether it was left there for a stable branch.
struct StabilityLoss {
    double load_factor = 0.0;  ///< critical: the tangent is singular there
    NodeIndex node;            ///< the reported node at which the critical mode is largest, and
    Dof dof =
        Dof::ux;  ///< in which component: the push goes along it, in its positive sense. Where no reported
                  ///< node moves: the one nearest to where the mode is largest inside of a beam
    bool pushed = false;  ///< the path goes on along a stable branch, after a push along that mode
};

/// One equilibrium of a structure.
struct Solution {
    double load_factor = 1.0;  ///< share of the loads and prescribed displacements
    Termination termination = Termination::Converged;
    [[nodiscard]] bool converged() const { return termination == Termination::Converged; }
    bool stable = true;
    StabilityTest stability = StabilityTest::None;
    NodeValues displacements;          ///< one row for each reported node; rotations as rotation vectors
    NodeValues inner_displacements{};  ///< of the assembly's other nodes: inside divided beams, and hinges'
    NodeValues reactions;   ///< forces and moments that hold the structure; zero where nothing is held
    double energy = 0.0;    ///< J, elastic
    double residual = 0.0;  ///< norm of the out-of-balance forces relative to that of the loads and reactions
    int iterations = 0;     ///< linear solves since the last solution of the path
    std::vector<StabilityLoss> stability_losses{};  ///< since the last solution of the path
};

/// The end of a path (of at least one solution), with the iterations and stability losses of all of it.
Solution end_of_path(std::span<const Solution> path);

}  // namespace fretwork::mechanics
