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

/// How much a method may spend, and who may end it sooner.
struct Budget {
    long cost = 20000;                                         ///< in the problem's unit, > 0
    double seconds = std::numeric_limits<double>::infinity();  ///< wall time, > 0
    base::Control control{};  ///< asked before every evaluation, and receives the cost
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The best objective value after `cost`.
struct TracePoint {
    long cost = 0;
    double value = 0.0;
    friend bool operator==(const TracePoint&, const TracePoint&) = default;
};

/// A problem as methods see it: every evaluation passes here, is charged and remembered.
///
/// An evaluation is refused (nothing comes back) once the budget does not pay for it, and for a point outside
/// the bounds. It throws base::Stopped once the caller asks to stop. The objective, never its smoothed
/// version, decides what is best; NaN counts as infinite.
class Evaluator {
  public:
    /// Throws InputError if the bounds or the budget are invalid.
    Evaluator(base::Borrowed<Problem> problem, const Budget& budget);

    [[nodiscard]] const Problem& problem() const { return problem_; }
    [[nodiscard]] const Bounds& bounds() const { return problem_->bounds(); }

    std::optional<double> value(const Eigen::VectorXd& point);
    std::optional<GradientEvaluation> gradient(const Eigen::VectorXd& point, double smoothing = 0.0);
    std::optional<ResidualEvaluation> residuals(const Eigen::VectorXd& point, double smoothing = 0.0);
    std::optional<CurvatureEvaluation> curvature(const Eigen::VectorXd& point, double smoothing = 0.0);

    /// True as long as the budget pays for one more evaluation of this kind.
    [[nodiscard]] bool can_afford(Evaluation kind) const;

    [[nodiscard]] long cost() const { return cost_; }
    [[nodiscard]] long evaluations() const { return evaluations_; }
    [[nodiscard]] long derivative_evaluations() const { return derivative_evaluations_; }
    [[nodiscard]] long points_outside() const { return points_outside_; }  ///< refused
    [[nodiscard]] long failures() const { return failures_; }              ///< objective not finite
    [[nodiscard]] double best_value() const { return best_value_; }        ///< infinite before the first
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
