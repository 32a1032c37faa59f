// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/paths/branch.hpp>
#include <fretwork/mechanics/results/solution.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics {

/// Options of the geometrically nonlinear solve.
struct EquilibriumOptions {
    /// A solution has converged below this residual. Rounding can prevent this, as for very short beams
    /// beside long ones, or for a hundred thousand beams. A residual below 1e-4 then suffices once steps are
    /// below 1e-13 (rad and element lengths). Within 1e-7 of rest, any residual that rounding explains
    /// suffices.
    double relative_residual = 1e-9;
    /// Largest rotation of a node in a Newton step, rad; longer steps are shortened. There is no line search,
    /// because the residual may grow while membrane forces build up.
    double largest_rotation_step = 0.6;
    int iterations_per_step = 60;     ///< largest number of plain Newton iterations at one load
    bool classify_stability = true;   ///< true: count negative pivots at each equilibrium
    Branch branch = Branch::Primary;  ///< equilibria to follow where the path is unstable
    /// True: fill Solution::stability_losses. With Stable and Snapping, they are always filled; with Primary,
    /// the limit load at which a path ends is always listed.
    bool locate_critical_loads = false;
    /// Number of threads; 0: one for each processor. The result is bitwise the same for every number of
    /// threads. Small structures use one thread.
    int threads = 1;
    base::Control control{};  ///< progress counts the share of the load that is reached
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The load factors 1 / steps, 2 / steps, .., 1.
std::vector<double> even_load_factors(int steps);

/// Follow the load path from rest through the given load factors (ascending, > 0; 1 = the full load):
/// Newton's method with a consistent tangent and a predictor from the path so far. With Branch::Primary, if
/// critical loads need not be located and the next load factor is far or the first, a mixed Newton method
/// reaches it in few long increments. If the path might branch before the next load factor, it is followed by
/// its arc length [Riks1979] instead. The steps are so short that the tangents at both ends predict the move
/// between them. Returns one solution for each load factor. If a load factor is not reached, its solution and
/// all later ones have not converged; they hold the last equilibrium found and its load factor.
///
/// Termination::LimitLoad: the load falls along the path beyond the last equilibrium; the last entry of
/// Solution::stability_losses is this limit load, unless a snap from it failed. Termination::Diverged: not
/// even the shortest step continues the path. Termination::IterationsSpent: the load was not reached in 3,000
/// steps along the path, or a descent in energy took more than 2,000 steps.
///
/// With Branch::Stable, a structure in an unstable equilibrium is pushed along its lowest mode and descends
/// in energy to a stable equilibrium, from which the path continues. Solution::stability_losses lists each
/// push.
///
/// With Branch::Snapping, the path also continues beyond limit loads: the load factor is raised by a
/// thousandth, and the structure descends in energy from its last equilibrium to a stable equilibrium.
/// Solution::stability_losses lists each snap as a loss at the limit load, with the node and the component
/// that move farthest, and with `pushed` set. If there are several stable equilibria, a real motion with
/// inertia may end in another one.
///
/// The relative rotation of the ends of an element must stay below pi, because an element cannot tell a
/// larger rotation from one in the opposite sense. A path ends as diverged where a relative rotation reaches
/// pi. Finer divisions reduce relative rotations.
///
/// Rotation vectors are continuous along the path and may grow beyond half a turn. The moment of a reaction
/// is the true moment in space, even if only some rotation components are held. Throws InputError if an
/// option is invalid or the factors are not ascending, NumericalError as LinearSolver if the structure can
/// move without strain at rest, and Stopped.
std::vector<Solution> follow_load_path(const Assembly& assembly, std::span<const double> load_factors,
                                       const EquilibriumOptions& options = {});

}  // namespace fretwork::mechanics
