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
    double turn_bound = 0.0;  ///< rad; upper bound on the relative rotation of the two ends of any element
};

/// An upper bound on the relative rotation of the two ends of any element after a step from a point, in rad.
/// It is more than pi if an element may have turned so far during the step that its number of whole turns is
/// unknown. While the rotations of the nodes alone keep the bound safely small, no element is evaluated.
/// @param turned  rad; upper bound on the rotation of any node during the step
double bound_relative_turn(const NonlinearSystem& system, const PathPoint& from, double turned,
                           const Configuration& to);

/// True if a step is longer than the rates at its two ends account for. Such a step may have jumped to
/// another path.
/// @param made   the step's change of each unknown
/// @param rates  for each unknown, the larger of the absolute rates at the two ends, times the step of the
/// load factor
bool is_jump(const Unknowns& unknowns, const Eigen::VectorXd& made, const Eigen::VectorXd& rates);

/// True if rates have grown so much over a step that a bifurcation may be near. Rates grow without bound
/// there, and the ends of a long step may lie on different sides of it, on two paths.
bool is_softened(const Unknowns& unknowns, const Eigen::VectorXd& first_rate,
                 const Eigen::VectorXd& last_rate);

/// Follow a load path in few long increments of mixed iterations, each of which may turn nodes by up to a
/// radian. Only the ends of the increments are known. The result is Converged if all of them seem to lie on
/// one path: they have the same number of negative pivots, and no move is much larger than the rates at its
/// two ends account for. Otherwise `point` does not change, and the caller has to follow the path in smaller
/// steps.
Termination stride(NonlinearSystem& system, Newton& newton, MixedNewton& mixed, PathPoint& point,
                   double target);

}  // namespace fretwork::mechanics::nonlinear
