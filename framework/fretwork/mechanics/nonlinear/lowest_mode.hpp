// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/stride.hpp>

namespace fretwork::mechanics::nonlinear {

/// The direction in which a structure is least stable in a configuration.
struct LowestMode {
    double eigenvalue = 0.0;  ///< lowest eigenvalue of the tangent's symmetric part relative to the system's
                              ///< weights; below zero: unstable
    Eigen::VectorXd shape;    ///< change of the unknowns; the largest component is +1 (displacements count in
                              ///< characteristic lengths)
};

/// A shift of the tangent of the size of its rounding error. A tangent that this shift makes definite is
/// stable or neutral.
double rounding_shift(const NonlinearSystem& system);

/// The lowest mode of the tangent of the last evaluation, by inverse iteration with the tangent shifted until
/// it is positive definite. Leaves the shifted tangent factorized.
LowestMode lowest_mode(const NonlinearSystem& system, Newton& newton);

/// Describe a loss of stability by the largest component of its mode, if possible at a reported node. Changes
/// the sign of the mode so that this component is positive. The load factor is left unset.
StabilityLoss describe_loss(const NonlinearSystem& system, LowestMode& mode);

/// Descend in energy from a configuration to an equilibrium under this load factor. The equilibrium is stable
/// or neutral; a round column that buckles in any direction has neutral ones. The steps are Newton's where
/// the tangent is positive definite; elsewhere the tangent is first shifted until it is. On Converged the
/// system is evaluated there.
Termination descend(double load_factor, NonlinearSystem& system, Newton& newton,
                    Configuration& configuration);

/// The load factor and the lowest eigenvalue of an equilibrium.
struct LowestEigenvalue {
    double load_factor;
    double eigenvalue;
};

/// The load factor at which the lowest eigenvalue vanishes between a stable equilibrium and an unstable one
/// at a distance `move` from it, by the method of false position (the Illinois rule halves the weight of an
/// end that stays).
double critical_load_factor(NonlinearSystem& system, Newton& newton, const PathPoint& from,
                            LowestEigenvalue unstable, const Eigen::VectorXd& move);

}  // namespace fretwork::mechanics::nonlinear
