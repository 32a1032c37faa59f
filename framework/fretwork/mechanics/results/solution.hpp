// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::mechanics {

/// The way in which a solution ended. "Not converged" is an outcome, not an error.
enum class Termination { Converged, LimitLoad, Diverged, IterationsSpent };
/// The word for it in files and messages.
std::string_view termination_name(Termination termination);

/// The test that decided about the stability of an equilibrium.
enum class StabilityTest {
    None,           ///< not asked for, or not applicable (a linear solution)
    Tangent,        ///< the inertia of the symmetric tangent: necessary and sufficient
    SymmetricPart,  ///< the inertia of the tangent's symmetric part, with moments of fixed direction on
                    ///< freely turning nodes: only sufficient
};
/// The word for it in files.
std::string_view stability_test_name(StabilityTest test);

/// A place where a path became unstable, and whether the solution continued on a stable branch.
struct StabilityLoss {
    double load_factor = 0.0;  ///< critical load factor, at which the tangent is singular
    NodeIndex node;            ///< the reported node at which the critical mode is largest; if no reported
                               ///< node moves, the one nearest to the largest motion inside a beam
    Dof dof = Dof::ux;    ///< the component in which the mode is largest; the push is in its positive sense
    bool pushed = false;  ///< true if the path continues on a stable branch after a push along that mode
};

/// One equilibrium of a structure.
struct Solution {
    double load_factor = 1.0;                          ///< factor on the loads and prescribed displacements
    Termination termination = Termination::Converged;  ///< how it ended
    /// True if the wanted load was reached.
    [[nodiscard]] bool converged() const { return termination == Termination::Converged; }
    bool stable = true;                             ///< no negative pivot
    StabilityTest stability = StabilityTest::None;  ///< how stability was tested
    NodeValues displacements;          ///< one row for each reported node; rotations as rotation vectors
    NodeValues inner_displacements{};  ///< rows of the assembly's other nodes: those inside divided beams and
                                       ///< of hinges
    NodeValues reactions;              ///< forces and moments of the supports; zero in free components
    double energy = 0.0;               ///< elastic energy, J
    double residual = 0.0;  ///< norm of the out-of-balance forces relative to that of the loads and reactions
    int iterations = 0;     ///< linear solves since the last solution of the path
    std::vector<StabilityLoss> stability_losses{};  ///< since the last solution of the path
};

/// The last solution of a path, with the iterations and stability losses of the whole path. Pre: the path is
/// not empty.
Solution end_of_path(std::span<const Solution> path);

}  // namespace fretwork::mechanics
