// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/limits.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::mechanics {

/// How the search for a solution ended. Not to converge is an outcome, not an error.
enum class Termination {
    Converged,       ///< the solution is an equilibrium
    LimitLoad,       ///< the path turns back at a load below the wanted load
    Diverged,        ///< no equilibrium was found
    IterationsSpent  ///< the iterations were used up
};
/// The word for a termination in files and messages.
std::string_view termination_name(Termination termination);

/// The test that decided whether an equilibrium is stable.
enum class StabilityTest {
    None,     ///< no test was requested, or none applies (a linear solution)
    Tangent,  ///< the signs of the pivots of the symmetric tangent, a necessary and sufficient test
    /// The signs of the pivots of the tangent's symmetric part, where moments of fixed direction act on nodes
    /// with at least two free rotations; the test is only sufficient.
    SymmetricPart,
};
/// The word for a test in files.
std::string_view stability_test_name(StabilityTest test);

/// A loss of stability: the place where a path became unstable.
struct StabilityLoss {
    double load_factor = 0.0;  ///< critical load factor, at which the tangent is singular
    /// Reported node with the largest motion in the critical mode; if no reported node moves, the one nearest
    /// to the largest motion inside a beam.
    NodeIndex node;
    /// Component in which the mode is largest; the push is in the positive sense of this component.
    Dof dof = Dof::ux;
    /// True if the path continues on a stable branch, after a push along the critical mode or after a snap.
    bool pushed = false;
};

/// One equilibrium of a structure.
struct Solution {
    double load_factor = 1.0;                          ///< factor on loads and prescribed displacements
    Termination termination = Termination::Converged;  ///< the way in which the search ended
    /// True if the wanted load was reached.
    [[nodiscard]] bool converged() const { return termination == Termination::Converged; }
    bool stable = true;  ///< true if all pivots of the tangent are positive, or if there was no test
    StabilityTest stability = StabilityTest::None;  ///< the test of stability
    /// True if the wanted load was reached, and no test says that the equilibrium is not stable.
    [[nodiscard]] bool is_stable_equilibrium() const { return converged() && stable; }
    /// True if the test has found that the equilibrium is unstable. A test that is only sufficient leaves it
    /// undecided.
    [[nodiscard]] bool is_unstable() const { return !stable && stability == StabilityTest::Tangent; }
    NodeValues displacements;  ///< one row for each reported node; rotations as rotation vectors
    /// Rows of the assembly's other nodes, which lie inside divided beams or belong to hinges. The row of a
    /// hinge is the motion of the beam's end relative to its node, in the beam's axes.
    NodeValues inner_displacements{};
    /// Forces and moments of the supports, one row for each reported node; zero in free components. After a
    /// nonlinear solution, a node with any held rotation has all three moments.
    NodeValues reactions;
    double energy = 0.0;    ///< elastic energy, J
    double residual = 0.0;  ///< norm of the unbalanced forces over the norm of loads and reactions
    /// Number of linear solves since the last solution of the path; of relax(): its number of iterations.
    int iterations = 0;
    /// Losses of stability since the last solution of the path.
    std::vector<StabilityLoss> stability_losses{};
};

/// The limits of a component of a solution's displacements. Result files have no values beyond them.
const base::Limits& motion_limits(Dof dof);

/// Check that the displacements lie within motion_limits(). Throws NumericalError with the largest ones: a
/// load or a stiffness is then out of any sensible range.
void require_sensible_motion(const Solution& solution);

/// The last solution of a path, with the iterations and stability losses of the whole path. Pre: the path is
/// not empty.
Solution end_of_path(std::span<const Solution> path);

}  // namespace fretwork::mechanics
