// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::design::detail {

/// Coordinates in which patterns of similar stiffness lie near each other: the leading principal components
/// of the columns of stiffness_logarithms(), at most three rows, one column for each pattern.
Eigen::MatrixXd leading_coordinates(const Eigen::MatrixXd& logarithms);

/// The weights with which values at known places predict the value at another place, by universal kriging
/// with the variogram |d|. The sum of the weights is one, and affine functions of the first coordinate are
/// predicted exactly.
/// @param known  the known places, one column for each, at least two columns
Eigen::VectorXd prediction_weights(const Eigen::MatrixXd& known, const Eigen::VectorXd& place);

}  // namespace fretwork::design::detail
