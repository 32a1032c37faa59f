// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/stride.hpp>

namespace fretwork::mechanics::nonlinear {

/// The mode in which a structure is least stable in a configuration.
struct LowestMode {
    /// Lowest eigenvalue of the tangent's symmetric part, relative to the system's weights; below zero:
    /// unstable.
    double eigenvalue = 0.0;
    Eigen::VectorXd shape;  ///< change of the unknowns; the largest component is +1 (displacements count in
                            ///< characteristic lengths)
};

/// A shift of the tangent by a few hundred times its rounding error. If this shift makes the tangent positive
/// definite, the equilibrium is stable or neutral.
double rounding_shift(const NonlinearSystem& system);

/// The lowest mode of the tangent of the last evaluation, by inverse iteration with the tangent shifted until
/// it is positive definite. After the call, `newton` has the factors of the shifted tangent.
LowestMode lowest_mode(const NonlinearSystem& system, Newton& newton);

/// Describe a loss of stability at a load factor by the largest component of its mode, if possible at a
/// reported node. The sign of the mode is changed so that this component is positive. The node is invalid if
/// the mode moves nothing.
StabilityLoss describe_loss(const NonlinearSystem& system, LowestMode& mode, double load_factor);

/// Descend in energy from a configuration to an equilibrium under this load factor. The equilibrium is stable
/// or neutral; a round column, which may buckle in any direction, has neutral equilibria. The steps are
/// Newton's steps. Where the tangent is not positive definite, it is first shifted until it is. On Converged,
/// the system is evaluated at the equilibrium.
Termination descend(double load_factor, NonlinearSystem& system, Newton& newton,
                    Configuration& configuration);

/// The load factor and the lowest eigenvalue of an equilibrium.
struct LowestEigenvalue {
    double load_factor;
    double eigenvalue;
};

/// The load factor at which the lowest eigenvalue vanishes between the stable equilibrium `from` and an
/// unstable equilibrium after the step `move`. The method is false position; by the Illinois rule, the weight
/// of an end that does not change is halved.
double critical_load_factor(NonlinearSystem& system, Newton& newton, const PathPoint& from,
                            LowestEigenvalue unstable, const Eigen::VectorXd& move);

}  // namespace fretwork::mechanics::nonlinear
