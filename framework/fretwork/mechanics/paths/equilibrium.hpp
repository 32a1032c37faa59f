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
    /// Converged below this; or below 1e-4 where rounding does not let it come lower: a step then changes
    /// nothing any more (1e-13 rad and element lengths). So it is with very short beams beside long ones, and
    /// with a hundred thousand beams (3e-9).
    double relative_residual = 1e-9;
    double largest_rotation_step = 0.6;  ///< rad; a Newton step is shortened to it. No line search: the
                                         ///< residual may grow within a step while membrane forces build up
    int iterations_per_step = 60;
    bool classify_stability = true;
    Branch branch = Branch::Primary;
    bool locate_critical_loads =
        false;        ///< fill Solution::stability_losses; branches but the primary always do
    int threads = 1;  ///< 0: all there are. They change no bit of a result, and small structures use one.
    base::Control control{};  ///< receives how much of the load is reached
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The load factors 1 / steps, 2 / steps, .., 1.
std::vector<double> even_load_factors(int steps);

/// Follow the load path from rest through the given load factors (ascending, > 0; 1 = the full load):
/// corotational Newton with a consistent tangent, and a predictor from the path so far. Where critical loads
/// need not be located and a load is far, the path goes there in few long increments of a mixed Newton
/// method, as long as what it meets speaks for one path; where that is in doubt, along its arc [Riks1979] in
/// steps whose ends account for the move between them. One solution for each factor; once a factor is not
/// reached, it and those after it say so, and hold the last equilibrium that was found and its factor.
///
/// Termination::LimitLoad: the load falls along the path beyond the last equilibrium; this is the last of
/// Solution::stability_losses. Termination::Diverged: no step, however short, continues the path.
/// Termination::IterationsSpent: the load was not reached in 3,000 steps along the path.
///
/// With Branch::Stable, an equilibrium that has lost its stability is pushed along its lowest mode and let
/// down to a stable one, and the path goes on from there; each such place is one of
/// Solution::stability_losses.
///
/// With Branch::Snapping, the path also goes on beyond limit loads: a thousandth of its load factor farther,
/// the structure goes downhill from its last equilibrium to a stable one. Such a place is a stability loss at
/// the limit load, with the node and the component that move farthest, `pushed`. A motion with inertia may
/// come to rest elsewhere where there are several stable equilibria.
///
/// An element knows the turn of its ends against each other up to whole turns: a path on which this comes
/// to pi ends there as diverged; it needs more divisions.
///
/// Rotation vectors are continuous along the path: beyond half a turn they go on growing. At nodes with a
/// held rotation component the reaction's moment is the true moment in space. Throws InputError if the
/// factors are not ascending, NumericalError that names a node if the structure can move without strain at
/// rest, and Stopped.
std::vector<Solution> follow_load_path(const Assembly& assembly, std::span<const double> load_factors,
                                       const EquilibriumOptions& options = {});

}  // namespace fretwork::mechanics
