// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/trials.hpp>

#include <optional>

namespace fretwork::design::detail {

/// A lower bound of the misfit of every painting with the palette, in linear theory.
///
/// Let A <= K_p <= B, as quadratic forms, for the stiffness K_p of a tile with any of its possible patterns
/// p. Summed over the tiles, K_A <= K <= K_B holds for every painting, and therefore K_B^-1 <= K^-1 <=
/// K_A^-1. With D = K_A^-1 - K_B^-1, it follows that K^-1 = (K_A^-1 + K_B^-1) / 2 + D^1/2 X D^1/2 / 2 with
/// |X| <= 1. So the displacements K^-1 F of all paintings lie in an ellipsoid, and so do the observations C
/// K^-1 F. The bound is the distance of the wanted values from the ellipsoid of the observations, in at most
/// 24 directions (Lanczos vectors of the ellipsoid's shape). A Lagrange multiplier gives this distance.
///
/// None if the bound does not hold: a wanted displacement is above 2 % of the surface's size; weight acts,
/// which changes with the painting; supports are moved; there are free unknowns besides the painting; nodes
/// may slide along a mesh; or the supports do not hold the surface. Throws Stopped.
std::optional<double> reach_bound(const Trials& trials, const std::vector<std::size_t>& palette,
                                  const base::Control& control);

/// A lower and an upper bound of positive definite matrices, as quadratic forms.
struct Enclosure {
    Eigen::MatrixXd below;
    Eigen::MatrixXd above;
    /// Enclose another matrix; the first one becomes both bounds. The positive part of its difference from
    /// `above` is added to `above`, and the negative part of its difference from `below` is subtracted from
    /// `below`, each in the metric of that bound.
    void include(const Eigen::MatrixXd& matrix);
};

/// The distance from a point to the ellipsoid { z: z . H^-1 z <= r^2 } with the positive semidefinite `shape`
/// H and the `radius` r. The result is a little below the true distance.
double distance_to_ellipsoid(const Eigen::MatrixXd& shape, double radius, const Eigen::VectorXd& point);

}  // namespace fretwork::design::detail
