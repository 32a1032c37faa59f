// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/ceres_descent.hpp>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fretwork::optimization::detail {
namespace {

/// The variables that the gradient does not press against a bound.
std::vector<Eigen::Index> free_variables(const Eigen::VectorXd& point, const Eigen::VectorXd& gradient,
                                         const Bounds& bounds) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < point.size(); ++i) {
        const bool is_pressed = (point[i] <= bounds.lower[i] && gradient[i] > 0.0) ||
                                (point[i] >= bounds.upper[i] && gradient[i] < 0.0);
        if (!is_pressed) free.push_back(i);
    }
    return free;
}

/// The model as residuals for Ceres. Ceres cuts its unconstrained step off at the bounds, and converges
/// slowly if a bound is active. So these residuals do not depend on the variables that are pressed against a
/// bound.
Linearization embed(const CurvatureEvaluation& model, const std::vector<Eigen::Index>& free) {
    const Eigen::Index n = model.gradient.size();
    const Eigen::Index size = free.size();
    Linearization result{Eigen::VectorXd::Zero(n + 1), Eigen::MatrixXd::Zero(n + 1, n)};
    if (size > 0) {
        Eigen::MatrixXd H = model.curvature(free, free);
        const double floor = std::max(H.diagonal().maxCoeff(), 1e-300);
        // This term keeps H positive definite in spite of round-off. It also keeps the square root for the
        // last residual real.
        H.diagonal().array() += 1e-13 * floor;
        const Eigen::LLT<Eigen::MatrixXd> factor(H);
        result.residuals.head(size) = factor.matrixL().solve(model.gradient(free));
        const Eigen::MatrixXd root = factor.matrixU();
        for (Eigen::Index k = 0; k < size; ++k) {
            result.jacobian.col(free[k]).head(size) = root.col(k);
        }
    }
    result.residuals[n] = std::sqrt(std::max(2.0 * model.value - result.residuals.squaredNorm(), 0.0));
    return result;
}

/// The gain of an undamped step that the model of embed() predicts.
double foreseen_gain(const Linearization& model) {
    return 0.5 * model.residuals.head(model.residuals.size() - 1).squaredNorm();
}

constexpr double kFirstRadius = 100.0;  // Ceres' damping is the inverse of the radius

}  // namespace

CeresDescent::CeresDescent(Evaluator& evaluator, const ContinuationOptions& options, Eigen::VectorXd start)
    : evaluator_(evaluator),
      options_(options),
      point_(std::move(start)),
      value_(std::numeric_limits<double>::infinity()),
      trust_region_radius_(kFirstRadius) {}

Ending CeresDescent::run_stage(double smoothing) {
    const double tolerance =
        smoothing == options_.smoothing.back() ? options_.tolerance : options_.loose_tolerance;
    bool is_refused = false;
    const CeresTask task{.linearize = [&](const Eigen::VectorXd& at) -> std::optional<Linearization> {
                             const auto model = evaluator_.curvature(at, smoothing);
                             is_refused = !model;
                             if (is_refused) return std::nullopt;
                             if (!std::isfinite(model->value)) return std::nullopt;
                             return embed(*model, free_variables(at, model->gradient, evaluator_.bounds()));
                         },
                         .residuals = static_cast<int>(point_.size()) + 1,
                         .bounds = evaluator_.bounds(),
                         .is_converged =
                             [&](const Linearization& model) {
                                 return foreseen_gain(model) <=
                                        tolerance * 0.5 * model.residuals.squaredNorm();
                             }};
    const CeresOutcome outcome = solve_with_ceres(task,
                                                  {.tolerance = tolerance,
                                                   .largest_iterations = options_.largest_iterations,
                                                   .trust_region_radius = trust_region_radius_},
                                                  point_);
    if (is_refused) return Ending::BudgetSpent;
    if (outcome.trust_region_radius > 0.0) trust_region_radius_ = outcome.trust_region_radius;
    value_ = outcome.cost;
    return outcome.converged ? Ending::Converged : Ending::Stalled;
}

}  // namespace fretwork::optimization::detail
