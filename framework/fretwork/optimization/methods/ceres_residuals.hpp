// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>
#include <vector>

namespace fretwork::optimization {

/// The method by which Ceres chooses its steps.
enum class CeresStep {
    LevenbergMarquardt,  ///< Ceres' default
    Dogleg,              ///< on the path from the steepest to the Gauss-Newton step [Powell1970]
    SubspaceDogleg,      ///< anywhere in the plane of these two steps [Byrd1988]
};

/// The method that keeps variables within their bounds.
enum class CeresBounds {
    Projection,  ///< Ceres' own method: it projects the steps of its trust region, and converges slowly if a
                 ///< bound is active
    Sine,        ///< x = middle + half width * sin(u): u is free, but the slope vanishes on the bounds
};

/// Options of Ceres on residuals.
struct CeresResidualsOptions {
    OptimizerOptions common{};                       ///< starts and seed
    double tolerance = 1e-8;                         ///< relative change of Ceres' cost at which it stops
    int largest_iterations = 200;                    ///< of one descent
    CeresStep step = CeresStep::LevenbergMarquardt;  ///< how a step is chosen
    CeresBounds bounds = CeresBounds::Projection;    ///< how bounds are kept
    std::vector<double> smoothing = {0.0};           ///< the smoothing of each stage, descending; see Problem
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Ceres on the problem's residuals, from low-discrepancy starts. By default the kinks are not smoothed. This
/// is the straightforward use of Ceres.
std::unique_ptr<Optimizer> make_ceres_residuals(const CeresResidualsOptions& options);

}  // namespace fretwork::optimization
