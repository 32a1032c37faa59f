// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

namespace fretwork::optimization::detail {

/// The minimizer p of g.p + p.H p / 2 within bounds that contain 0, by a primal active-set method, exact up
/// to round-off. Made for a few variables. Pre: H is positive definite.
Eigen::VectorXd minimize_box_quadratic(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                       const Bounds& bounds);

}  // namespace fretwork::optimization::detail
