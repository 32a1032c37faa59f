// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/continuation.hpp>

namespace fretwork::optimization::detail {

/// Descend from `point` by Ceres on the problem's generalized Gauss-Newton model, stage by stage of the
/// smoothing, and leave the point where that ends. See make_ceres_multistart.
Ending descend_by_ceres(Evaluator& evaluator, const ContinuationOptions& options, Eigen::VectorXd& point);

}  // namespace fretwork::optimization::detail
