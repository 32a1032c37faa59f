// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/ceres_solve.hpp>

#include <ceres/ceres.h>

#include <algorithm>
#include <glog/logging.h>

namespace fretwork::optimization::detail {
namespace {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A cost function that remembers its last evaluation. Ceres requests the value at a trial point, and, once
/// it accepts the point, the Jacobian at the same point; one evaluation serves both requests.
class RememberingCost final : public ceres::CostFunction {
  public:
    RememberingCost(const CeresTask& task, int parameters) : linearize_(task.linearize) {
        set_num_residuals(task.residuals);
        mutable_parameter_block_sizes()->push_back(parameters);
    }

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        const Eigen::Map<const Eigen::VectorXd> point(parameters[0], parameter_block_sizes()[0]);
        if (!can_evaluate(point)) return false;
        Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = last_->residuals;
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            Eigen::Map<RowMajorMatrix>(jacobians[0], num_residuals(), point.size()) = last_->jacobian;
        }
        return true;
    }

    /// Evaluate the point if it is new. False if there are no residuals, as after a spent budget, or if they
    /// or their derivatives are not finite. Ceres then takes a shorter step, but would end at an accepted
    /// point without finite derivatives.
    [[nodiscard]] bool can_evaluate(const Eigen::VectorXd& point) const {
        if (last_point_.size() == 0 || last_point_ != point) {
            last_ = linearize_(point);
            last_point_ = point;
        }
        return last_ && last_->residuals.allFinite() && last_->jacobian.allFinite();
    }
    [[nodiscard]] const std::optional<Linearization>& last() const { return last_; }

  private:
    const decltype(CeresTask::linearize)& linearize_;
    mutable Eigen::VectorXd last_point_;
    mutable std::optional<Linearization> last_;
};

/// Ends the run as soon as the task accepts a point as converged.
class StopWhenConverged final : public ceres::IterationCallback {
  public:
    StopWhenConverged(const CeresTask& task, const RememberingCost& cost)
        : is_converged_(task.is_converged), cost_(cost) {}

    ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
        // After a rejected step, the last evaluation belongs to the rejected trial point.
        return step.step_is_successful && is_converged_(*cost_.last()) ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                                       : ceres::SOLVER_CONTINUE;
    }

  private:
    const decltype(CeresTask::is_converged)& is_converged_;
    const RememberingCost& cost_;
};

/// Ceres warns on stderr if its subspace dogleg takes the step of a plain dogleg; users can do nothing about
/// it. In a program that has set up glog, the settings stay.
void silence_warnings() {
    static const bool is_done = [] {
        if (!google::IsGoogleLoggingInitialized()) {
            FLAGS_minloglevel = std::max<int>(FLAGS_minloglevel, google::GLOG_ERROR);
        }
        return true;
    }();
    (void)is_done;
}

void choose_step(CeresStep step, ceres::Solver::Options& options) {
    if (step == CeresStep::LevenbergMarquardt) return;
    options.trust_region_strategy_type = ceres::DOGLEG;
    options.dogleg_type = step == CeresStep::Dogleg ? ceres::TRADITIONAL_DOGLEG : ceres::SUBSPACE_DOGLEG;
}

ceres::Solver::Options solver_options(const CeresSettings& settings) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    options.max_num_iterations = settings.largest_iterations;
    options.function_tolerance = settings.tolerance;
    options.gradient_tolerance = 1e-14;
    options.parameter_tolerance = 1e-12;
    options.max_num_consecutive_invalid_steps = 1;
    options.initial_trust_region_radius = settings.trust_region_radius;
    choose_step(settings.step, options);
    return options;
}

void set_bounds(ceres::Problem& problem, const Bounds& bounds, double* point) {
    for (int i = 0; i < bounds.dimension(); ++i) {
        problem.SetParameterLowerBound(point, i, bounds.lower[i]);
        problem.SetParameterUpperBound(point, i, bounds.upper[i]);
    }
}

}  // namespace

CeresOutcome solve_with_ceres(const CeresTask& task, const CeresSettings& settings, Eigen::VectorXd& point) {
    RememberingCost cost(task, static_cast<int>(point.size()));
    // Ceres logs an error if the first evaluation fails, although a spent budget is a normal end.
    if (!cost.can_evaluate(point)) return {};
    ceres::Problem::Options ownership;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    problem.AddParameterBlock(point.data(), static_cast<int>(point.size()));
    if (task.bounds) set_bounds(problem, *task.bounds, point.data());
    problem.AddResidualBlock(&cost, nullptr, point.data());
    silence_warnings();
    ceres::Solver::Options options = solver_options(settings);
    StopWhenConverged stop(task, cost);
    if (task.is_converged) options.callbacks.push_back(&stop);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (task.bounds) point = task.bounds->clamp(point);
    if (summary.iterations.empty()) return {};  // Ceres could not begin
    return {.converged = summary.termination_type == ceres::CONVERGENCE ||
                         summary.termination_type == ceres::USER_SUCCESS,
            .cost = summary.final_cost,
            .trust_region_radius = summary.iterations.back().trust_region_radius};
}

}  // namespace fretwork::optimization::detail
