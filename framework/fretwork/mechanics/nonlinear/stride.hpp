// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/mixed_newton.hpp>

namespace fretwork::mechanics::nonlinear {

/// rad, and element lengths: moves as small as this are linear.
inline constexpr double kLinearMove = 1e-6;

/// An equilibrium of a load path.
struct PathPoint {
    Configuration configuration;
    double load_factor = 0.0;
    Eigen::VectorXd rate;  ///< of the unknowns in the load factor
    sparse::Ldlt::Outcome outcome;
    double turn_bound = 0.0;  ///< rad; upper bound on the relative rotation of the two ends of any element
};

/// An upper bound on the relative rotation of the two ends of any element after a step from a point, in rad.
/// It is more than pi if an element may have turned so far during the step that its number of whole turns is
/// unknown. While the rotations of the nodes alone keep the bound safely small, no element is evaluated.
/// @param turned  rad; upper bound on the rotation of any node during the step
double bound_relative_turn(const NonlinearSystem& system, const PathPoint& from, double turned,
                           const Configuration& to);

/// Whether a step has gone farther than the rates at its ends account for: then it may have passed over a gap
/// of the path, to another one.
/// @param made   the step's change of each unknown
/// @param rates  for each unknown, the larger of the absolute rates at the two ends, times the step of the
/// load factor
bool is_jump(const Unknowns& unknowns, const Eigen::VectorXd& made, const Eigen::VectorXd& rates);

/// Whether rates have grown so much over a step that a bifurcation may be near: there they grow without
/// bound, and the ends of a long step may lie on the two sides of it, on two paths.
bool is_softened(const Unknowns& unknowns, const Eigen::VectorXd& first_rate,
                 const Eigen::VectorXd& last_rate);

/// Follow a load path in few long increments of mixed iterations, each of which turns nodes by up to a
/// radian. What it sees of the path are the ends of the increments. Converged if they all speak for one path:
/// the same number of negative pivots, and no move much larger than the rates at both of its ends account
/// for. Otherwise the point stays where it is; the path is then to be followed in smaller steps.
Termination stride(NonlinearSystem& system, Newton& newton, MixedNewton& mixed, PathPoint& point,
                   double target);

}  // namespace fretwork::mechanics::nonlinear
