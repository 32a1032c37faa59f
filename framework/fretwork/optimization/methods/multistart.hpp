// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>
#include <vector>

namespace fretwork::optimization {

/// Options of a descent by continuation, which runs in stages. Each stage minimizes the objective with less
/// smoothing than the stage before, and the last stage minimizes nearly the objective itself.
struct ContinuationOptions {
    std::vector<double> smoothing = {1e-1, 1e-2, 1e-3, 1e-4};  ///< smoothing of each stage, descending
    /// Every stage but the last ends if a step is predicted to lower the value by less than this share of it.
    double loose_tolerance = 1e-3;
    double tolerance = 1e-7;      ///< the corresponding share for the last stage
    int largest_iterations = 60;  ///< largest number of iterations in one stage
    /// Number of points sampled for each descent. The descents start at the best of all these points.
    int samples_per_start = 12;
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Options of several descents by continuation. All descents finish a stage before the next stage begins.
struct MultistartOptions {
    OptimizerOptions common{};           ///< number of starts, and seed
    ContinuationOptions continuation{};  ///< options of each descent
    /// Two descents are in one valley if they differ in every variable by less than this share of the range
    /// between its bounds. After a stage, the one with the larger value ends. 0: no descent ends for this
    /// reason.
    double merging_distance = 0.01;
    /// A descent also ends if its value after a stage exceeds v + (pruning_ratio - 1) |v|, where v is the
    /// lowest value of all descents. The ratio is at least 1. Infinity: no descent ends for this reason.
    double pruning_ratio = 2.0;
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Descents by Ceres' Levenberg-Marquardt method with bounds, on the problem's generalized Gauss-Newton
/// model.
///
/// Ceres sees the residuals [L^-1 g; sqrt(2 E - |L^-1 g|^2)] with the Jacobian [L^T; 0], where E is the
/// value, g the gradient and L L^T the curvature of the smoothed objective. Variables that the gradient
/// presses against a bound are left out of g and L. Ceres' cost for these residuals is E, the gradient of the
/// cost is g, and the normal matrix is L L^T, so Ceres minimizes E itself. The square root is real if the
/// curvature is at least 2 J^T J, where J is the Jacobian of residuals with the squared norm E. The model
/// predicts that an undamped step lowers E by half the squared norm of L^-1 g. A callback ends the stage if
/// this decrease is at most the tolerance times E. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_ceres_multistart(const MultistartOptions& options);

/// Levenberg-Marquardt descents with the problem's generalized Gauss-Newton matrix: every step minimizes the
/// damped quadratic model exactly over the bounds. This method differs from make_ceres_multistart() only in
/// its steps, and in the tests that end a stage. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_gauss_newton_multistart(const MultistartOptions& options);

}  // namespace fretwork::optimization
