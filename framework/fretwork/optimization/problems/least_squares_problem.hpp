// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

#include <functional>
#include <string>

namespace fretwork::optimization {

/// A problem with a sum of squares as objective, given by its residuals and their Jacobian. The problem
/// offers every kind of evaluation; without a Jacobian, it offers values only.
class LeastSquaresProblem final : public Problem {
  public:
    /// The function that gives the residuals at a point.
    using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
    /// The function that gives the derivatives of the residuals at a point, one row for each residual.
    using Jacobian = std::function<Eigen::MatrixXd(const Eigen::VectorXd&)>;
    /// Make a problem from its residuals. The Jacobian may be empty.
    LeastSquaresProblem(std::string name, Bounds bounds, Residuals residuals, Jacobian jacobian);

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(Evaluation kind) const override {
        return kind == Evaluation::Value || jacobian_ != nullptr;
    }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override;
    [[nodiscard]] GradientEvaluation gradient(const Eigen::VectorXd& x, double smoothing) const override;
    [[nodiscard]] ResidualEvaluation residuals(const Eigen::VectorXd& x, double smoothing) const override;
    [[nodiscard]] CurvatureEvaluation curvature(const Eigen::VectorXd& x, double smoothing) const override;

  private:
    std::string name_;
    Bounds bounds_;
    Residuals residuals_;
    Jacobian jacobian_;
};

}  // namespace fretwork::optimization
