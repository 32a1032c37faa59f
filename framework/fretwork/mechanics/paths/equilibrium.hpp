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
    /// A solution has converged below this residual. Where rounding keeps the residual above it, a solution
    /// has converged below 1e-4, once steps are below 1e-13 (rad and element lengths). Very short beams
    /// beside long ones do so, and a hundred thousand beams.
    double relative_residual = 1e-9;
    double largest_rotation_step = 0.6;  ///< rad; longer Newton steps are shortened. There is no line search:
                                         ///< the residual may grow while membrane forces build up
    int iterations_per_step = 60;
    bool classify_stability = true;
    Branch branch = Branch::Primary;
    bool locate_critical_loads = false;  ///< fill Solution::stability_losses; Stable and Snapping always do
    int threads = 1;  ///< 0: all there are. They change no bit of a result, and small structures use one.
    base::Control control{};  ///< receives the share of the load that is reached
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The load factors 1 / steps, 2 / steps, .., 1.
std::vector<double> even_load_factors(int steps);

/// Follow the load path from rest through the given load factors (ascending, > 0; 1 = the full load):
/// corotational Newton with a consistent tangent, and a predictor from the path so far. If critical loads
/// need not be located and the next load is far, a mixed Newton method goes there in few long increments.
/// Where the path might branch on the way, it is followed by its arc length [Riks1979] instead, in steps so
/// short that the tangents at both ends account for the move between them. Returns one solution for each
/// factor. If a factor is not reached, its solution and all later ones have not converged; they hold the last
/// equilibrium found, and its factor.
///
/// Termination::LimitLoad: the load falls along the path beyond the last equilibrium; this is the last of
/// Solution::stability_losses. Termination::Diverged: no step, however short, continues the path.
/// Termination::IterationsSpent: the load was not reached in 3,000 steps along the path.
///
/// With Branch::Stable, an unstable equilibrium is pushed along its lowest mode and goes downhill to a stable
/// one, from which the path goes on. Each such place is one of Solution::stability_losses.
///
/// With Branch::Snapping, the path also goes on beyond limit loads: the load factor is raised by a
/// thousandth, and the structure goes downhill from its last equilibrium to a stable one. Such a place is a
/// stability loss at the limit load; it names the node and the component that move farthest, and is marked
/// `pushed`. If there are several stable equilibria, a motion with inertia may come to rest in another one.
///
/// The ends of an element can turn against each other by less than pi: beyond that, an element cannot tell
/// the turn from one the other way round. A path on which they reach pi ends there as diverged; finer
/// divisions avoid it.
///
/// Rotation vectors are continuous along the path: beyond half a turn they go on growing. The moment of a
/// reaction is the true moment in space, also where only some rotation components are held. Throws InputError
/// if the factors are not ascending, NumericalError that names a node if the structure can move without
/// strain at rest, and Stopped.
std::vector<Solution> follow_load_path(const Assembly& assembly, std::span<const double> load_factors,
                                       const EquilibriumOptions& options = {});

}  // namespace fretwork::mechanics
