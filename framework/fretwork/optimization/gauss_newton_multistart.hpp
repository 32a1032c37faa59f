// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/continuation.hpp>

#include <memory>

namespace fretwork::optimization {

struct GaussNewtonMultistartOptions {
    OptimizerOptions common{};
    ContinuationOptions continuation{};
    /// Of two descents that are nearer than this after a stage, as a share of the bounds in every variable,
    /// the one with the larger value ends: they are in one valley. 0: all go on.
    double merging_distance = 0.01;
    void validate() const;
};

/// Levenberg-Marquardt descents with the problem's generalized Gauss-Newton matrix: every step minimizes the
/// damped quadratic model exactly over the bounds. Descents begin at the best of many sampled points and
/// follow the smoothing down together, stage by stage; those that meet go on as one.
std::unique_ptr<Optimizer> make_gauss_newton_multistart(const GaussNewtonMultistartOptions& options);

}  // namespace fretwork::optimization
