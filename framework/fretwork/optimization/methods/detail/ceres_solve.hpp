// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/ceres_residuals.hpp>

#include <functional>
#include <limits>
#include <optional>

namespace fretwork::optimization::detail {

/// Residuals in Ceres' convention: the cost is half of their squared norm.
struct Linearization {
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;
};

/// The problem that Ceres minimizes. `linearize` returns nothing if the budget is spent, or if the objective
/// is not finite.
struct CeresTask {
    std::function<std::optional<Linearization>(const Eigen::VectorXd&)> linearize;
    int residuals = 0;
    std::optional<Bounds> bounds{};  ///< none: any point is valid
    /// Returns true to end the run. Called at the first point and at every point that Ceres accepts. None:
    /// Ceres' own tests decide alone.
    std::function<bool(const Linearization&)> is_converged{};
};

struct CeresSettings {
    double tolerance = 1e-8;  ///< relative change of the cost at which Ceres stops
    int largest_iterations = 200;
    CeresStep step = CeresStep::LevenbergMarquardt;
    double trust_region_radius = 1e4;  ///< initial radius; Ceres' own default
};

struct CeresOutcome {
    bool converged = false;
    double cost = std::numeric_limits<double>::infinity();  ///< cost at the last point
    double trust_region_radius = 0.0;                       ///< radius at the end; 0: Ceres did not begin
};

/// Run Ceres from `point`, and set `point` to the point at which Ceres stops.
CeresOutcome solve_with_ceres(const CeresTask& task, const CeresSettings& settings, Eigen::VectorXd& point);

}  // namespace fretwork::optimization::detail
