// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

#include <string>

namespace fretwork::optimization {

/// The squared sum of distances to points, (sum_q |x - p_q|)^2, where p_q are the columns of a matrix. This
/// objective has a kink at each point. With smoothing mu, each distance |d| becomes sqrt(d.d + mu^2). The
/// problem has one residual, the sum of the distances.
class DistanceSumProblem final : public Problem {
  public:
    /// Make the problem for the points that are the columns of `points`.
    DistanceSumProblem(Bounds bounds, Eigen::MatrixXd points);

    [[nodiscard]] std::string name() const override { return "distance-sum"; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(Evaluation) const override { return true; }
    [[nodiscard]] bool has_kinks() const override { return true; }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override;
    [[nodiscard]] GradientEvaluation gradient(const Eigen::VectorXd& x, double smoothing) const override;
    [[nodiscard]] ResidualEvaluation residuals(const Eigen::VectorXd& x, double smoothing) const override;
    [[nodiscard]] CurvatureEvaluation curvature(const Eigen::VectorXd& x, double smoothing) const override;

  private:
    Bounds bounds_;
    Eigen::MatrixXd points_;
};

}  // namespace fretwork::optimization
