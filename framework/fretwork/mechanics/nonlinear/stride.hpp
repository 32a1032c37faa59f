// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/mixed_newton.hpp>

namespace fretwork::mechanics::nonlinear {

/// Moves up to this size, in rad and element lengths, count as linear.
inline constexpr double kLinearMove = 1e-6;

/// An equilibrium of a load path.
struct PathPoint {
    Configuration configuration;
    double load_factor = 0.0;
    Eigen::VectorXd rate;  ///< derivative of the unknowns with respect to the load factor
    sparse::Ldlt::Outcome outcome;
    double turn_bound = 0.0;  ///< upper bound on the relative rotation of the two ends of any element, rad
};

/// An upper bound on the relative rotation of the two ends of any element after a step from a point, rad. The
/// bound is above pi if an element may have turned so far that its number of whole turns is unknown. No
/// element is evaluated if the rotations of the nodes give a bound that is small enough.
/// @param turned  upper bound on the rotation of any node during the step, rad
double bound_relative_turn(const NonlinearSystem& system, const PathPoint& from, double turned,
                           const Configuration& to);

/// The same bound. The rotations of free nodes come from `move`, those of prescribed nodes from the change of
/// the load factor.
double bound_relative_turn(const NonlinearSystem& system, const PathPoint& from, const Eigen::VectorXd& move,
                           double load_factor, const Configuration& to);

/// True if a step is longer than the rates at its two ends predict: it may have jumped to another path.
/// @param made   the absolute change of each unknown in the step
/// @param rates  for each unknown, the larger absolute rate of the two ends, times the step of the load
/// factor
bool is_jump(const Unknowns& unknowns, const Eigen::VectorXd& made, const Eigen::VectorXd& rates);

/// True if rates have grown so much over a step that a bifurcation may be near. At a bifurcation, rates grow
/// without bound, and the two ends of a long step may lie on two paths, on different sides of the
/// bifurcation.
bool is_softened(const Unknowns& unknowns, const Eigen::VectorXd& first_rate,
                 const Eigen::VectorXd& last_rate);

/// Follow a load path in few long increments of mixed iterations; each may turn nodes by up to 2.5 rad. The
/// first step of an increment turns them by about 0.4 rad at most (0.7 rad where a rotation is prescribed).
/// Only the ends of the increments are known. The result is Converged if all ends seem to lie on one path:
/// they have the same number of negative pivots, rates do not grow much, and no move is much larger than the
/// rates at its two ends predict. Otherwise `point` does not change, and the caller has to follow the path in
/// smaller steps.
Termination stride(NonlinearSystem& system, Newton& newton, MixedNewton& mixed, PathPoint& point,
                   double target);

}  // namespace fretwork::mechanics::nonlinear
