// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/problems/distance_sum_problem.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fretwork::optimization {

DistanceSumProblem::DistanceSumProblem(Bounds bounds, Eigen::MatrixXd points)
    : bounds_(std::move(bounds)), points_(std::move(points)) {}

double DistanceSumProblem::value(const Eigen::VectorXd& x) const {
    const double sum = (points_.colwise() - x).colwise().norm().sum();
    return sum * sum;
}

GradientEvaluation DistanceSumProblem::gradient(const Eigen::VectorXd& x, double smoothing) const {
    const auto model = curvature(x, smoothing);
    return {model.objective, model.value, model.gradient};
}

ResidualEvaluation DistanceSumProblem::residuals(const Eigen::VectorXd& x, double smoothing) const {
    const auto model = curvature(x, smoothing);
    const double root = std::sqrt(model.value);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(1, x.size());  // as the gradient in the kink itself
    if (root > 0.0) jacobian = model.gradient.transpose() / (2.0 * root);
    return {model.objective, Eigen::VectorXd::Constant(1, root), jacobian};
}

CurvatureEvaluation DistanceSumProblem::curvature(const Eigen::VectorXd& x, double smoothing) const {
    double sum = 0.0;
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(x.size());
    Eigen::MatrixXd bend = Eigen::MatrixXd::Zero(x.size(), x.size());
    for (Eigen::Index q = 0; q < points_.cols(); ++q) {
        const Eigen::VectorXd d = x - points_.col(q);
        const double a = std::max(std::sqrt(d.squaredNorm() + smoothing * smoothing), 1e-300);
        sum += a;
        slope += d / a;
        bend += Eigen::MatrixXd::Identity(x.size(), x.size()) / a -
                d * d.transpose() / std::max(a * a * a, 1e-300);
    }
    return {value(x), sum * sum, 2.0 * sum * slope, 2.0 * slope * slope.transpose() + 2.0 * sum * bend};
}

}  // namespace fretwork::optimization
