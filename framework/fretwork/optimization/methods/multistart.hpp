// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>
#include <vector>

namespace fretwork::optimization {

/// Options of a descent by continuation: its stages have less and less smoothing, and the last is nearly the
/// objective itself.
struct ContinuationOptions {
    std::vector<double> smoothing = {1e-1, 1e-2, 1e-3, 1e-4};  ///< the smoothing of each stage, descending
    double loose_tolerance = 1e-3;  ///< all stages but the last end if a step lowers the value by less than
                                    ///< this share
    double tolerance = 1e-7;        ///< this share for the last stage
    int largest_iterations = 60;    ///< in one stage
    int samples_per_start = 12;     ///< points sampled for each descent, which starts at the best; 1: no
                                    ///< choice
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Options of several descents by continuation. All of them finish a stage before the next begins.
struct MultistartOptions {
    OptimizerOptions common{};           ///< starts and seed
    ContinuationOptions continuation{};  ///< how kinks are smoothed
    /// If two descents are nearer than this after a stage, as a share of the bounds in every variable, the
    /// one with the larger value ends, because both are in one valley. 0: none ends for this reason.
    double merging_distance = 0.01;
    /// A descent also ends if its value after a stage is more than this multiple of the lowest value; >= 1.
    /// Infinity: none ends for this reason.
    double pruning_ratio = 2.0;
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Descents by Ceres' Levenberg-Marquardt method with bounds, on the problem's generalized Gauss-Newton
/// model.
///
/// Ceres sees the residuals [L^-1 g; sqrt(2 E - |L^-1 g|^2)] with the Jacobian [L^T; 0], where E, g and
/// L L^T are value, gradient and curvature. The cost of these residuals is E, their gradient g, and their
/// normal matrix L L^T, so Ceres minimizes E itself. The root is real if the curvature is at least 2 J^T J of
/// residuals whose squared norm is E. By the model, an undamped step lowers E by half the squared norm of
/// L^-1 g; a callback ends the stage if this is below the tolerance.
std::unique_ptr<Optimizer> make_ceres_multistart(const MultistartOptions& options);

/// Levenberg-Marquardt descents with the problem's generalized Gauss-Newton matrix: every step minimizes the
/// damped quadratic model exactly over the bounds. Only the steps differ from those of make_ceres_multistart.
std::unique_ptr<Optimizer> make_gauss_newton_multistart(const MultistartOptions& options);

}  // namespace fretwork::optimization
