// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/problems/least_squares_problem.hpp>

#include <utility>

namespace fretwork::optimization {

LeastSquaresProblem::LeastSquaresProblem(std::string name, Bounds bounds, Residuals residuals,
                                         Jacobian jacobian)
    : name_(std::move(name)),
      bounds_(std::move(bounds)),
      residuals_(std::move(residuals)),
      jacobian_(std::move(jacobian)) {}

double LeastSquaresProblem::value(const Eigen::VectorXd& x) const {
    return residuals_(x).squaredNorm();
}

GradientEvaluation LeastSquaresProblem::gradient(const Eigen::VectorXd& x, double smoothing) const {
    if (!jacobian_) return Problem::gradient(x, smoothing);
    const Eigen::VectorXd r = residuals_(x);
    return {r.squaredNorm(), r.squaredNorm(), 2.0 * jacobian_(x).transpose() * r};
}

ResidualEvaluation LeastSquaresProblem::residuals(const Eigen::VectorXd& x, double smoothing) const {
    if (!jacobian_) return Problem::residuals(x, smoothing);
    const Eigen::VectorXd r = residuals_(x);
    return {r.squaredNorm(), r, jacobian_(x)};
}

CurvatureEvaluation LeastSquaresProblem::curvature(const Eigen::VectorXd& x, double smoothing) const {
    if (!jacobian_) return Problem::curvature(x, smoothing);
    const Eigen::VectorXd r = residuals_(x);
    const Eigen::MatrixXd J = jacobian_(x);
    return {r.squaredNorm(), r.squaredNorm(), 2.0 * J.transpose() * r, 2.0 * J.transpose() * J};
}

}  // namespace fretwork::optimization
