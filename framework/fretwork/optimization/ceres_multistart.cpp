// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/optimization/ceres_multistart.hpp>
#include <fretwork/optimization/detail/starts.hpp>

#include <Eigen/Cholesky>
#include <ceres/ceres.h>

#include <cmath>

namespace fretwork::optimization {
namespace {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Residuals as Ceres counts: the cost is half their squared norm.
struct Linearization {
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;
};
/// Nothing, once the budget is spent.
using Linearize = std::function<std::optional<Linearization>(const Eigen::VectorXd&)>;

/// Ceres asks for the value at a trial point, and for the Jacobian at the same point once it accepts it: one
/// evaluation serves both.
class RememberingCost final : public ceres::CostFunction {
  public:
    RememberingCost(Linearize linearize, int residuals, int parameters) : linearize_(std::move(linearize)) {
        set_num_residuals(residuals);
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

    /// Evaluates, unless this is the last point again.
    [[nodiscard]] bool can_evaluate(const Eigen::VectorXd& point) const {
        if (last_point_.size() == 0 || last_point_ != point) {
            last_ = linearize_(point);
            last_point_ = point;
        }
        return last_ && last_->residuals.allFinite();
    }

  private:
    Linearize linearize_;
    mutable Eigen::VectorXd last_point_;
    mutable std::optional<Linearization> last_;
};

Linearization embed(const CurvatureEvaluation& model) {
    const Eigen::Index n = model.gradient.size();
    Eigen::MatrixXd H = model.curvature;
    const double floor = std::max(H.diagonal().maxCoeff(), 1e-300);
    // Positive definite in spite of round-off; a larger matrix keeps the root below real.
    H.diagonal().array() += 1e-13 * floor;
    const Eigen::LLT<Eigen::MatrixXd> factor(H);
    Linearization result{Eigen::VectorXd(n + 1), Eigen::MatrixXd::Zero(n + 1, n)};
    result.residuals.head(n) = factor.matrixL().solve(model.gradient);
    const double rest = 2.0 * model.value - result.residuals.head(n).squaredNorm();
    result.residuals[n] = std::sqrt(std::max(rest, 0.0));
    result.jacobian.topRows(n) = factor.matrixU();
    return result;
}

ceres::Solver::Options solver_options(double tolerance, int iterations) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    options.max_num_iterations = iterations;
    options.function_tolerance = tolerance;
    options.gradient_tolerance = 1e-14;
    options.parameter_tolerance = 1e-12;
    options.max_num_consecutive_invalid_steps = 1;
    return options;
}

/// Run Ceres from `point`, and leave the point where it stops there.
bool descend(const ceres::Solver::Options& options, RememberingCost& cost, const Bounds& bounds,
             Eigen::VectorXd& point) {
    // Ceres logs an error if the very first evaluation fails, although that is a normal end of the budget.
    if (!cost.can_evaluate(point)) return false;
    ceres::Problem::Options ownership;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    problem.AddParameterBlock(point.data(), static_cast<int>(point.size()));
    for (int i = 0; i < point.size(); ++i) {
        problem.SetParameterLowerBound(point.data(), i, bounds.lower[i]);
        problem.SetParameterUpperBound(point.data(), i, bounds.upper[i]);
    }
    problem.AddResidualBlock(&cost, nullptr, point.data());
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    point = bounds.clamp(point);
    return summary.termination_type == ceres::CONVERGENCE;
}

class CeresMultistart final : public Optimizer {
  public:
    explicit CeresMultistart(const CeresMultistartOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        RunOutcome outcome{Termination::BudgetSpent, {}};
        const int samples = options_.common.starts * options_.continuation.samples_per_start;
        for (const Eigen::VectorXd& start : detail::choose_starts(evaluator, options_.common, samples)) {
            outcome.final_point = start;
            outcome.termination = follow_smoothing(evaluator, outcome.final_point);
            if (outcome.termination == Termination::BudgetSpent) break;
        }
        return outcome;
    }

  private:
    Termination follow_smoothing(Evaluator& evaluator, Eigen::VectorXd& point) const {
        const ContinuationOptions& stages = options_.continuation;
        bool converged = true;
        for (const double smoothing : stages.smoothing) {
            const double tolerance =
                smoothing == stages.smoothing.back() ? stages.tolerance : stages.loose_tolerance;
            const auto size = static_cast<int>(point.size());
            RememberingCost cost(
                [&](const Eigen::VectorXd& at) -> std::optional<Linearization> {
                    const auto model = evaluator.curvature(at, smoothing);
                    if (!model) return std::nullopt;
                    return embed(*model);
                },
                size + 1, size);
            converged = descend(solver_options(tolerance, stages.largest_iterations), cost,
                                evaluator.bounds(), point);
            if (!evaluator.can_afford(Evaluation::Curvature)) return Termination::BudgetSpent;
        }
        return converged ? Termination::Converged : Termination::Stalled;
    }

    CeresMultistartOptions options_;
};

class CeresResiduals final : public Optimizer {
  public:
    explicit CeresResiduals(const CeresResidualsOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        RunOutcome outcome{Termination::BudgetSpent, {}};
        for (const Eigen::VectorXd& start : detail::choose_starts(evaluator, options_.common, 0)) {
            outcome.final_point = start;
            outcome.termination = descend_from(evaluator, outcome.final_point);
            if (outcome.termination == Termination::BudgetSpent) break;
        }
        return outcome;
    }

  private:
    Termination descend_from(Evaluator& evaluator, Eigen::VectorXd& point) const {
        const auto first = evaluator.residuals(point);
        if (!first) return Termination::BudgetSpent;
        RememberingCost cost(
            [&](const Eigen::VectorXd& at) -> std::optional<Linearization> {
                auto model = evaluator.residuals(at);
                if (!model) return std::nullopt;
                // Ceres halves the squared norm.
                return Linearization{std::sqrt(2.0) * model->residuals, std::sqrt(2.0) * model->jacobian};
            },
            static_cast<int>(first->residuals.size()), static_cast<int>(point.size()));
        const bool converged = descend(solver_options(options_.tolerance, options_.largest_iterations), cost,
                                       evaluator.bounds(), point);
        if (!evaluator.can_afford(Evaluation::Residuals)) return Termination::BudgetSpent;
        return converged ? Termination::Converged : Termination::Stalled;
    }

    CeresResidualsOptions options_;
};

}  // namespace

void CeresMultistartOptions::validate() const {
    common.validate();
    continuation.validate();
}

void CeresResidualsOptions::validate() const {
    common.validate();
    if (!(tolerance > 0.0) || largest_iterations < 1) {
        throw base::InputError("ceres-residuals: tolerance must be more than 0, iterations at least 1");
    }
}

std::unique_ptr<Optimizer> make_ceres_multistart(const CeresMultistartOptions& options) {
    options.validate();
    return std::make_unique<CeresMultistart>(options);
}

std::unique_ptr<Optimizer> make_ceres_residuals(const CeresResidualsOptions& options) {
    options.validate();
    return std::make_unique<CeresResiduals>(options);
}

}  // namespace fretwork::optimization
