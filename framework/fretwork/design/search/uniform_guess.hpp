// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::design::detail {

/// Coordinates of patterns, near each other for similar stiffness: the leading principal components of the
/// columns of stiffness_logarithms(), at most three rows, one column for each pattern.
Eigen::MatrixXd leading_coordinates(const Eigen::MatrixXd& logarithms);

/// The weights that predict the value at a place from values at known places, by universal kriging with the
/// variogram |d|. They sum up to one, and affine functions of the first coordinate are predicted exactly.
/// @param known  the known places, one column for each, at least two columns
Eigen::VectorXd prediction_weights(const Eigen::MatrixXd& known, const Eigen::VectorXd& place);

}  // namespace fretwork::design::detail
