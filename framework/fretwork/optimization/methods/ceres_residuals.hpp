// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>
#include <vector>

namespace fretwork::optimization {

/// How Ceres chooses its steps.
enum class CeresStep {
    LevenbergMarquardt,
    Dogleg,          ///< on the path from the steepest to the Gauss-Newton step [Powell1970]
    SubspaceDogleg,  ///< anywhere in the plane that the two span [Byrd1988]
};

/// How bounds are kept.
enum class CeresBounds {
    Projection,  ///< Ceres' own: it cuts off the steps of its trust region, and creeps where a bound is
                 ///< active
    Sine,        ///< x = middle + half width * sin(u): u is free, but the slope vanishes on the bounds
};

struct CeresResidualsOptions {
    OptimizerOptions common{};
    double tolerance = 1e-8;  ///< relative change of the cost, at which Ceres stops
    int largest_iterations = 200;
    CeresStep step = CeresStep::LevenbergMarquardt;
    CeresBounds bounds = CeresBounds::Projection;
    std::vector<double> smoothing = {0.0};  ///< stage by stage, descending; see Problem
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Ceres on the problem's residuals from low-discrepancy starts; by default with kinks and all: the method
/// that one writes first.
std::unique_ptr<Optimizer> make_ceres_residuals(const CeresResidualsOptions& options);

}  // namespace fretwork::optimization
