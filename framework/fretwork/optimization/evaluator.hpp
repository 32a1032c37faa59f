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
    long cost = 20000;                                         ///< largest cost, in the problem's unit, > 0
    double seconds = std::numeric_limits<double>::infinity();  ///< largest wall time, s, > 0
    /// Stop and progress; the stop is checked before every evaluation, and progress counts the cost.
    base::Control control{};
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The best objective value found up to a cost.
struct TracePoint {
    long cost = 0;       ///< cost spent so far, in the problem's unit
    double value = 0.0;  ///< best objective found at that cost
    friend bool operator==(const TracePoint&, const TracePoint&) = default;
};

/// The access of a method to the problem. Every evaluation passes through the evaluator, which charges it to
/// the budget and remembers the best point. Only one thread at a time may use it.
///
/// An evaluation is refused and returns nothing if the rest of the budget does not cover it, or if the point
/// is outside the bounds. An evaluation throws base::Stopped if the caller asks to stop. The best point is
/// the point with the lowest objective, not with the lowest smoothed value; NaN counts as infinite.
class Evaluator {
  public:
    /// Begin a run. Throws InputError if the bounds or the budget are invalid.
    Evaluator(base::Borrowed<Problem> problem, const Budget& budget);

    /// The problem to minimize.
    [[nodiscard]] const Problem& problem() const { return problem_; }
    /// The bounds of the variables.
    [[nodiscard]] const Bounds& bounds() const { return problem_->bounds(); }
    /// The control of the budget, for methods that wait for something other than evaluations.
    [[nodiscard]] const base::Control& control() const { return budget_.control; }

    /// The objective at a point; none if the evaluation is refused.
    std::optional<double> value(const Eigen::VectorXd& point);
    /// The objective and a gradient at a point; none if the evaluation is refused.
    std::optional<GradientEvaluation> gradient(const Eigen::VectorXd& point, double smoothing = 0.0);
    /// The residuals and their Jacobian at a point; none if the evaluation is refused.
    std::optional<ResidualEvaluation> residuals(const Eigen::VectorXd& point, double smoothing = 0.0);
    /// The gradient and the curvature at a point; none if the evaluation is refused.
    std::optional<CurvatureEvaluation> curvature(const Eigen::VectorXd& point, double smoothing = 0.0);

    /// True if the rest of the budget covers one more evaluation of this kind.
    [[nodiscard]] bool can_afford(Evaluation kind) const;

    /// True once the time of the budget is over.
    [[nodiscard]] bool is_late() const;

    /// The cost spent so far, in the problem's unit.
    [[nodiscard]] long cost() const { return cost_; }
    /// The number of evaluations so far.
    [[nodiscard]] long evaluations() const { return evaluations_; }
    /// The number of evaluations with derivatives so far.
    [[nodiscard]] long derivative_evaluations() const { return derivative_evaluations_; }
    /// The number of evaluations refused so far because the point was outside the bounds.
    [[nodiscard]] long points_outside() const { return points_outside_; }
    /// The number of evaluations so far whose objective was not finite.
    [[nodiscard]] long failures() const { return failures_; }
    /// The lowest objective so far; infinite before the first finite objective.
    [[nodiscard]] double best_value() const { return best_value_; }
    /// The point with the lowest objective so far; empty if no objective was finite so far.
    [[nodiscard]] const Eigen::VectorXd& best_point() const { return best_point_; }
    /// The best objective over the cost: one entry for each improvement, with ascending cost and descending
    /// value.
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
