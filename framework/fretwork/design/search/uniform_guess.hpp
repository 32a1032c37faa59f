// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::design::detail {

/// Coordinates of patterns, one column for each: the leading principal components, at most three, of the
/// columns of stiffness_logarithms(). Patterns of similar stiffness are near each other.
Eigen::MatrixXd leading_coordinates(const Eigen::MatrixXd& logarithms);

/// The weights that predict the value at a place from values at known places, by universal kriging. The
/// variogram is the distance, and the trend is affine in the first coordinate, so affine functions of it are
/// predicted exactly. The weights sum to one.
/// @param known  the known places, one column for each, at least two columns
Eigen::VectorXd prediction_weights(const Eigen::MatrixXd& known, const Eigen::VectorXd& place);

}  // namespace fretwork::design::detail
