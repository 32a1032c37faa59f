// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/optimization/ceres_multistart.hpp>
#include <fretwork/optimization/detail/starts.hpp>

#include <Eigen/Cholesky>
#include <ceres/ceres.h>

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

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

/// One stage of the continuation. Ceres cuts its unconstrained step off at the bounds, and creeps where a
/// bound is active; so variables that are pressed against a bound are taken out of what it sees, and let in
/// again when the gradient turns.
class Stage {
  public:
    Stage(Evaluator& evaluator, const ContinuationOptions& options, double smoothing)
        : evaluator_(evaluator),
          smoothing_(smoothing),
          options_(solver_options(
              smoothing == options.smoothing.back() ? options.tolerance : options.loose_tolerance,
              options.largest_iterations)) {}

    Termination run(Eigen::VectorXd& point) {
        // Each pass changes what is held; two variables that keep changing places are left as they are.
        const Eigen::Index passes = 2 * point.size();
        std::vector<Eigen::Index> free;
        bool converged = true;
        for (Eigen::Index pass = 0; pass < passes; ++pass) {
            auto now_free = free_variables(point);
            if (!last_) return Termination::BudgetSpent;
            if (now_free == free || now_free.empty()) break;
            free = std::move(now_free);
            converged = descend_in(free, point);
            if (is_refused_) return Termination::BudgetSpent;
        }
        return converged ? Termination::Converged : Termination::Stalled;
    }

  private:
    /// The model at a point; the last one is kept. Nothing, once the budget is spent.
    const std::optional<CurvatureEvaluation>& model_at(const Eigen::VectorXd& point) {
        if (!last_ || last_point_ != point) {
            last_ = evaluator_.curvature(point, smoothing_);
            last_point_ = point;
            is_refused_ = !last_;
        }
        return last_;
    }

    std::vector<Eigen::Index> free_variables(const Eigen::VectorXd& point) {
        std::vector<Eigen::Index> free;
        const auto& model = model_at(point);
        if (!model) return free;
        const Bounds& bounds = evaluator_.bounds();
        for (Eigen::Index i = 0; i < point.size(); ++i) {
            const bool is_pressed = (point[i] <= bounds.lower[i] && model->gradient[i] > 0.0) ||
                                    (point[i] >= bounds.upper[i] && model->gradient[i] < 0.0);
            if (!is_pressed) free.push_back(i);
        }
        return free;
    }

    bool descend_in(const std::vector<Eigen::Index>& free, Eigen::VectorXd& point) {
        const auto size = static_cast<int>(free.size());
        RememberingCost cost(
            [&](const Eigen::VectorXd& at) -> std::optional<Linearization> {
                Eigen::VectorXd whole = point;
                whole(free) = at;
                const auto& model = model_at(whole);
                if (!model) return std::nullopt;
                return embed(
                    {model->objective, model->value, model->gradient(free), model->curvature(free, free)});
            },
            size + 1, size);
        const Bounds& bounds = evaluator_.bounds();
        Eigen::VectorXd free_point = point(free);
        const bool converged = descend(options_, cost, {bounds.lower(free), bounds.upper(free)}, free_point);
        point(free) = free_point;
        return converged;
    }

    Evaluator& evaluator_;
    double smoothing_;
    ceres::Solver::Options options_;
    std::optional<CurvatureEvaluation> last_;
    Eigen::VectorXd last_point_;
    bool is_refused_ = false;
};

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
        Termination termination = Termination::Converged;
        for (const double smoothing : options_.continuation.smoothing) {
            termination = Stage(evaluator, options_.continuation, smoothing).run(point);
            if (termination == Termination::BudgetSpent) break;
        }
        return termination;
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
