// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/continuation.hpp>

#include <memory>

namespace fretwork::optimization {

struct GaussNewtonMultistartOptions {
    OptimizerOptions common{};
    ContinuationOptions continuation{};
    void validate() const;
};

/// Levenberg-Marquardt descents with the problem's generalized Gauss-Newton matrix: every step minimizes the
/// damped quadratic model exactly over the bounds. Descents begin at the best of many sampled points and
/// follow the smoothing down stage by stage.
std::unique_ptr<Optimizer> make_gauss_newton_multistart(const GaussNewtonMultistartOptions& options);

}  // namespace fretwork::optimization
