// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/evaluator.hpp>

#include <cmath>

namespace fretwork::optimization {

void Budget::validate() const {
    if (cost < 1) throw base::InputError("budget: " + std::to_string(cost) + " must be at least 1");
    if (!(seconds > 0.0)) {
        throw base::InputError("budget: " + base::format_number(seconds) + " seconds must be more than 0");
    }
}

Evaluator::Evaluator(base::Borrowed<Problem> problem, const Budget& budget)
    : problem_(problem), budget_(budget), started_(std::chrono::steady_clock::now()) {
    budget_.validate();
    problem_->bounds().validate();
}

std::optional<double> Evaluator::value(const Eigen::VectorXd& point) {
    if (!charge(Evaluation::Value, point)) return std::nullopt;
    const double result = problem_->value(point);
    remember(point, result);
    return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
}

std::optional<GradientEvaluation> Evaluator::gradient(const Eigen::VectorXd& point, double smoothing) {
    if (!charge(Evaluation::Gradient, point)) return std::nullopt;
    auto result = problem_->gradient(point, smoothing);
    remember(point, result.objective);
    return result;
}

std::optional<ResidualEvaluation> Evaluator::residuals(const Eigen::VectorXd& point, double smoothing) {
    if (!charge(Evaluation::Residuals, point)) return std::nullopt;
    auto result = problem_->residuals(point, smoothing);
    remember(point, result.objective);
    return result;
}

std::optional<CurvatureEvaluation> Evaluator::curvature(const Eigen::VectorXd& point, double smoothing) {
    if (!charge(Evaluation::Curvature, point)) return std::nullopt;
    auto result = problem_->curvature(point, smoothing);
    remember(point, result.objective);
    return result;
}

bool Evaluator::can_afford(Evaluation kind) const {
    return cost_ + problem_->cost(kind) <= budget_.cost && !is_late();
}

bool Evaluator::is_late() const {
    if (std::isinf(budget_.seconds)) return false;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - started_;
    return elapsed.count() >= budget_.seconds;
}

bool Evaluator::charge(Evaluation kind, const Eigen::VectorXd& point) {
    budget_.control.check();
    if (!can_afford(kind)) return false;
    if (!problem_->bounds().contain(point)) {
        ++points_outside_;
        return false;
    }
    cost_ += problem_->cost(kind);
    ++evaluations_;
    if (budget_.control.progress != nullptr) budget_.control.progress->update(cost_);
    if (kind != Evaluation::Value) ++derivative_evaluations_;
    return true;
}

void Evaluator::remember(const Eigen::VectorXd& point, double objective) {
    if (!std::isfinite(objective)) {
        ++failures_;
        return;
    }
    if (objective >= best_value_) return;
    best_value_ = objective;
    best_point_ = point;
    trace_.push_back({cost_, objective});
}

}  // namespace fretwork::optimization
