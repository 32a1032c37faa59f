// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/base/control.hpp>
#include <fretwork/optimization/problem.hpp>

#include <chrono>
#include <limits>
#include <optional>
#include <vector>

namespace fretwork::optimization {

/// The limits of a run: its cost, its time, and the caller's stop.
struct Budget {
    long cost = 20000;                                         ///< in the problem's unit, > 0
    double seconds = std::numeric_limits<double>::infinity();  ///< wall time, > 0
    base::Control control{};  ///< checked before every evaluation; progress counts the cost
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The best objective value found up to a cost.
struct TracePoint {
    long cost = 0;       ///< spent until then, in the problem's unit
    double value = 0.0;  ///< the best objective by then
    friend bool operator==(const TracePoint&, const TracePoint&) = default;
};

/// The problem as a method sees it. Every evaluation passes through this class, which charges it to the
/// budget and remembers the best point.
///
/// An evaluation is refused and returns nothing if the rest of the budget does not cover it, or the point is
/// outside the bounds. It throws base::Stopped if the caller asks to stop. The best point is the one with the
/// lowest objective, not the lowest smoothed value; NaN counts as infinite.
class Evaluator {
  public:
    /// Throws InputError if the bounds or the budget are invalid.
    Evaluator(base::Borrowed<Problem> problem, const Budget& budget);

    /// What is minimized.
    [[nodiscard]] const Problem& problem() const { return problem_; }
    /// The problem's bounds.
    [[nodiscard]] const Bounds& bounds() const { return problem_->bounds(); }

    /// The objective; none if the budget does not pay for it.
    std::optional<double> value(const Eigen::VectorXd& point);
    /// The gradient with its objective; none if the budget does not pay for it.
    std::optional<GradientEvaluation> gradient(const Eigen::VectorXd& point, double smoothing = 0.0);
    /// Residuals and their Jacobian; none if the budget does not pay for it.
    std::optional<ResidualEvaluation> residuals(const Eigen::VectorXd& point, double smoothing = 0.0);
    /// Gradient and curvature; none if the budget does not pay for it.
    std::optional<CurvatureEvaluation> curvature(const Eigen::VectorXd& point, double smoothing = 0.0);

    /// True if the rest of the budget covers one more evaluation of this kind.
    [[nodiscard]] bool can_afford(Evaluation kind) const;

    /// What was spent, in the problem's unit.
    [[nodiscard]] long cost() const { return cost_; }
    /// How many evaluations there were.
    [[nodiscard]] long evaluations() const { return evaluations_; }
    /// How many of them had derivatives.
    [[nodiscard]] long derivative_evaluations() const { return derivative_evaluations_; }
    [[nodiscard]] long points_outside() const {
        return points_outside_;
    }  ///< evaluations refused for their
       ///< point
    [[nodiscard]] long failures() const {
        return failures_;
    }  ///< evaluations with a non-finite
       ///< objective
    [[nodiscard]] double best_value() const {
        return best_value_;
    }  ///< infinite before the first
       ///< evaluation
    /// Where the objective was least.
    [[nodiscard]] const Eigen::VectorXd& best_point() const { return best_point_; }
    /// One point for each improvement: cost ascending, value descending.
    [[nodiscard]] const std::vector<TracePoint>& trace() const { return trace_; }

  private:
    bool charge(Evaluation kind, const Eigen::VectorXd& point);
    void remember(const Eigen::VectorXd& point, double objective);

    base::Borrowed<Problem> problem_;
    Budget budget_;
    std::chrono::steady_clock::time_point started_;
    long cost_ = 0;
    long evaluations_ = 0;
    long derivative_evaluations_ = 0;
    long points_outside_ = 0;
    long failures_ = 0;
    double best_value_ = std::numeric_limits<double>::infinity();
    Eigen::VectorXd best_point_;
    std::vector<TracePoint> trace_;
};

}  // namespace fretwork::optimization
