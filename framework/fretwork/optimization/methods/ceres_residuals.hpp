// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>
#include <vector>

namespace fretwork::optimization {

/// The method by which Ceres chooses its steps.
enum class CeresStep {
    LevenbergMarquardt,  ///< Ceres' default
    /// A step on the path from the steepest-descent step to the Gauss-Newton step [Powell1970].
    Dogleg,
    SubspaceDogleg,  ///< a step anywhere in the plane of these two steps [Byrd1988]
};

/// The way in which variables are kept within their bounds.
enum class CeresBounds {
    /// Ceres' own method, which projects the steps of its trust region; it converges slowly if a bound is
    /// active.
    Projection,
    /// A variable is written x = middle + half width * sin(u). The new variable u has no bounds, but the
    /// slope dx/du vanishes on the bounds of x.
    Sine,
};

/// Options of make_ceres_residuals().
struct CeresResidualsOptions {
    OptimizerOptions common{};                       ///< number of starts, and seed
    double tolerance = 1e-8;                         ///< Ceres stops below this relative change of its cost
    int largest_iterations = 200;                    ///< largest number of iterations in one stage
    CeresStep step = CeresStep::LevenbergMarquardt;  ///< the choice of steps
    CeresBounds bounds = CeresBounds::Projection;    ///< the treatment of bounds
    /// Smoothing of each continuation stage, descending; see Problem.
    std::vector<double> smoothing = {0.0};
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Descents by Ceres on the problem's residuals, from low-discrepancy starts. By default, kinks of the
/// objective are not smoothed. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_ceres_residuals(const CeresResidualsOptions& options);

}  // namespace fretwork::optimization
