// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/multistart.hpp>

#include <memory>

namespace fretwork::optimization {

/// Levenberg-Marquardt descents with the problem's generalized Gauss-Newton matrix: every step minimizes the
/// damped quadratic model exactly over the bounds. It differs from make_ceres_multistart in the steps alone.
std::unique_ptr<Optimizer> make_gauss_newton_multistart(const MultistartOptions& options);

}  // namespace fretwork::optimization
