// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/stride.hpp>

namespace fretwork::mechanics::nonlinear {

/// The direction in which a structure at some configuration is least stable.
struct LowestMode {
    double eigenvalue = 0.0;  ///< of the tangent's symmetric part against the system's weights; below zero:
                              ///< unstable
    Eigen::VectorXd shape;    ///< of the unknowns; largest component (displacements in lengths) +1
};

/// A shift of the tangent that is to its entries as rounding is: what it makes definite is stable, or
/// neutral.
double rounding_shift(const NonlinearSystem& system);

/// By inverse iteration with the tangent of the last evaluation, shifted until it is positive definite.
/// Leaves the shifted tangent factorized.
LowestMode lowest_mode(const NonlinearSystem& system, Newton& newton);

/// Names a mode in which stability is lost by its largest component, preferably of a reported node, and turns
/// it so that this is positive. The load factor is left open.
StabilityLoss describe_loss(const NonlinearSystem& system, LowestMode& mode);

/// Go downhill from a configuration to an equilibrium that is stable, or neutral, as all those around an axis
/// in which a round column buckles, under this load factor: Newton's steps where the
/// tangent is positive definite, elsewhere steps with the tangent shifted until it is. On Converged the
/// system is evaluated there.
Termination descend(double load_factor, NonlinearSystem& system, Newton& newton,
                    Configuration& configuration);

/// An equilibrium by its load factor and its lowest eigenvalue.
struct LowestEigenvalue {
    double load_factor;
    double eigenvalue;
};

/// Where the lowest eigenvalue vanishes between a stable equilibrium and an unstable one that lies a move
/// away from it: the false position, halving the weight of an end that stays (the Illinois rule).
double critical_load_factor(NonlinearSystem& system, Newton& newton, const PathPoint& from,
                            LowestEigenvalue unstable, const Eigen::VectorXd& move);

}  // namespace fretwork::mechanics::nonlinear
