// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/trials.hpp>

#include <optional>

namespace fretwork::design::detail {

/// A lower bound of the misfit of every painting, in linear theory.
///
/// Let A <= K_p <= B, as quadratic forms, for every pattern p that a tile may have; summed over the tiles,
/// K_A <= K <= K_B holds for every painting, and so K_B^-1 <= K^-1 <= K_A^-1. With D = K_A^-1 - K_B^-1 then
/// K^-1 = (K_A^-1 + K_B^-1) / 2 + D^1/2 X D^1/2 / 2 with |X| <= 1: the displacements K^-1 F of all
/// paintings lie in an ellipsoid. So do the observations C K^-1 F, and the bound is the distance of the
/// wanted values from their ellipsoid, along some directions (as many as matter): a Lagrange multiplier gives
/// it.
///
/// None where it does not hold or says nothing: displacements that are large for linear theory, weight (it
/// changes with the painting), moved supports, unknowns besides the painting, surfaces to slide on.
std::optional<double> reach_bound(const Trials& trials, const std::vector<std::size_t>& palette,
                                  const base::Control& control);

/// Matrices of which one is below and one above all of some positive definite ones, as quadratic forms.
struct Enclosure {
    Eigen::MatrixXd below;
    Eigen::MatrixXd above;
    /// Take a further one in: the difference's positive part is added above, its negative part taken away
    /// below, in the metric of the bounds.
    void include(const Eigen::MatrixXd& matrix);
};

/// The distance from a point to the ellipsoid { z: z . H^-1 z <= r^2 } with H positive semidefinite, a little
/// too small.
double distance_to_ellipsoid(const Eigen::MatrixXd& shape, double radius, const Eigen::VectorXd& point);

}  // namespace fretwork::design::detail
