// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::design::detail {

/// Coordinates in which patterns that act alike lie near to each other: the leading principal components of
/// the columns of stiffness_logarithms(), at most three rows, one column for each pattern.
Eigen::MatrixXd leading_coordinates(const Eigen::MatrixXd& logarithms);

/// The weights with which values at known places predict the value at another place; they sum up to one, and
/// affine functions of the first coordinate are predicted exactly (universal kriging with the variogram |d|).
/// @param known  a column for each known place, at least two of them
Eigen::VectorXd prediction_weights(const Eigen::MatrixXd& known, const Eigen::VectorXd& place);

}  // namespace fretwork::design::detail
