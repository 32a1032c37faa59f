// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>
#include <vector>

namespace fretwork::optimization {

/// How a descent that smooths kinks proceeds: from well rounded to nearly the objective itself.
struct ContinuationOptions {
    std::vector<double> smoothing = {1e-1, 1e-2, 1e-3, 1e-4};  ///< stage by stage, descending
    double loose_tolerance = 1e-3;  ///< a stage but the last ends once a step gains less than this share
    double tolerance = 1e-7;        ///< the same for the last stage
    int largest_iterations = 60;    ///< of one stage
    int samples_per_start = 12;     ///< points that are tried for each descent; 1: none
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Many descents that follow the smoothing down together, stage by stage, from the best of sampled points.
struct MultistartOptions {
    OptimizerOptions common{};
    ContinuationOptions continuation{};
    /// If two descents are nearer than this after a stage, as a share of the bounds in every variable, the
    /// one with the larger value ends: they are in one valley. 0: all go on.
    double merging_distance = 0.01;
    /// A descent whose value after a stage is more than this multiple of the lowest one ends as well; >= 1.
    /// Infinity: none ends for its value.
    double pruning_ratio = 2.0;
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Ceres' Levenberg-Marquardt with bounds on the problem's generalized Gauss-Newton model.
///
/// Ceres sees the residuals [L^-1 g; sqrt(2 E - |L^-1 g|^2)] with the Jacobian [L^T; 0], where E, g and
/// L L^T are value, gradient and curvature: their cost is E, their gradient g and their normal matrix L L^T,
/// so that every point which Ceres accepts, and every one where it stops, is one of E itself. The root is
/// real wherever the curvature is at least 2 J^T J of residuals whose squared norm is E. Half the squared
/// norm of L^-1 g is what an undamped step gains by the model: a callback ends the stage once that is less
/// than its tolerance.
std::unique_ptr<Optimizer> make_ceres_multistart(const MultistartOptions& options);

/// Levenberg-Marquardt descents with the problem's generalized Gauss-Newton matrix: every step minimizes the
/// damped quadratic model exactly over the bounds. It differs from make_ceres_multistart in the steps alone.
std::unique_ptr<Optimizer> make_gauss_newton_multistart(const MultistartOptions& options);

}  // namespace fretwork::optimization
