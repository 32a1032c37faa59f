// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/detail/ceres_descent.hpp>
#include <fretwork/optimization/detail/ceres_solve.hpp>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fretwork::optimization::detail {
namespace {

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

/// One stage of the continuation. Ceres cuts its unconstrained step off at the bounds, and creeps where a
/// bound is active; so variables that are pressed against a bound are taken out of what it sees, and let in
/// again when the gradient turns.
class Stage {
  public:
    Stage(Evaluator& evaluator, const ContinuationOptions& options, double smoothing)
        : evaluator_(evaluator),
          smoothing_(smoothing),
          settings_{.tolerance =
                        smoothing == options.smoothing.back() ? options.tolerance : options.loose_tolerance,
                    .largest_iterations = options.largest_iterations} {}

    Ending run(Eigen::VectorXd& point) {
        // Each pass changes what is held; two variables that keep changing places are left as they are.
        const Eigen::Index passes = 2 * point.size();
        std::vector<Eigen::Index> free;
        bool converged = true;
        for (Eigen::Index pass = 0; pass < passes; ++pass) {
            auto now_free = free_variables(point);
            if (!last_) return Ending::BudgetSpent;
            if (now_free == free || now_free.empty()) break;
            free = std::move(now_free);
            converged = descend_in(free, point);
            if (is_refused_) return Ending::BudgetSpent;
        }
        return converged ? Ending::Converged : Ending::Stalled;
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
        const Bounds& bounds = evaluator_.bounds();
        CeresTask task{.linearize = [&](const Eigen::VectorXd& at) -> std::optional<Linearization> {
                           Eigen::VectorXd whole = point;
                           whole(free) = at;
                           const auto& model = model_at(whole);
                           if (!model) return std::nullopt;
                           return embed({model->objective, model->value, model->gradient(free),
                                         model->curvature(free, free)});
                       },
                       .residuals = static_cast<int>(free.size()) + 1,
                       .bounds = Bounds{bounds.lower(free), bounds.upper(free)}};
        Eigen::VectorXd free_point = point(free);
        const bool converged = solve_with_ceres(task, settings_, free_point);
        point(free) = free_point;
        return converged;
    }

    Evaluator& evaluator_;
    double smoothing_;
    CeresSettings settings_;
    std::optional<CurvatureEvaluation> last_;
    Eigen::VectorXd last_point_;
    bool is_refused_ = false;
};

}  // namespace

Ending descend_by_ceres(Evaluator& evaluator, const ContinuationOptions& options, Eigen::VectorXd& point) {
    Ending ending = Ending::Converged;
    for (const double smoothing : options.smoothing) {
        ending = Stage(evaluator, options, smoothing).run(point);
        if (ending == Ending::BudgetSpent) break;
    }
    return ending;
}

}  // namespace fretwork::optimization::detail
