// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace fretwork::optimization {

/// A sum of squares given by its residuals and their Jacobian: it offers every kind of evaluation.
class LeastSquaresProblem final : public Problem {
  public:
    using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
    using Jacobian = std::function<Eigen::MatrixXd(const Eigen::VectorXd&)>;
    LeastSquaresProblem(std::string name, Bounds bounds, Residuals residuals, Jacobian jacobian)
        : name_(std::move(name)),
          bounds_(std::move(bounds)),
          residuals_(std::move(residuals)),
          jacobian_(std::move(jacobian)) {}

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(Evaluation) const override { return true; }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override {
        return residuals_(x).squaredNorm();
    }
    [[nodiscard]] GradientEvaluation gradient(const Eigen::VectorXd& x, double) const override {
        return {value(x), value(x), 2.0 * jacobian_(x).transpose() * residuals_(x)};
    }
    [[nodiscard]] ResidualEvaluation residuals(const Eigen::VectorXd& x, double) const override {
        return {value(x), residuals_(x), jacobian_(x)};
    }
    [[nodiscard]] CurvatureEvaluation curvature(const Eigen::VectorXd& x, double) const override {
        const Eigen::MatrixXd J = jacobian_(x);
        return {value(x), value(x), 2.0 * J.transpose() * residuals_(x), 2.0 * J.transpose() * J};
    }

  private:
    std::string name_;
    Bounds bounds_;
    Residuals residuals_;
    Jacobian jacobian_;
};

inline Bounds cube(int dimension, double low, double high) {
    return {Eigen::VectorXd::Constant(dimension, low), Eigen::VectorXd::Constant(dimension, high)};
}

/// sum (x_i - c_i)^2 with c = (0.1, 0.2, ..).
inline LeastSquaresProblem sphere(int dimension) {
    const Eigen::VectorXd center = Eigen::VectorXd::LinSpaced(dimension, 0.1, 0.1 * dimension);
    return {"sphere", cube(dimension, -2.0, 3.0),
            [=](const Eigen::VectorXd& x) { return (x - center).eval(); },
            [=](const Eigen::VectorXd&) { return Eigen::MatrixXd::Identity(dimension, dimension).eval(); }};
}

/// (1 - x)^2 + 100 (y - x^2)^2, least in (1, 1).
inline LeastSquaresProblem rosenbrock(const Bounds& bounds) {
    return {"rosenbrock", bounds,
            [](const Eigen::VectorXd& x) {
                return Eigen::VectorXd(Eigen::Vector2d(1.0 - x[0], 10.0 * (x[1] - x[0] * x[0])));
            },
            [](const Eigen::VectorXd& x) {
                return Eigen::MatrixXd((Eigen::Matrix2d() << -1.0, 0.0, -20.0 * x[0], 10.0).finished());
            }};
}

/// (sum_q |x - p_q|)^2: the squared sum of distances to points, with a kink in each of them. `smoothing`
/// turns each |d| into sqrt(d.d + smoothing^2).
class DistanceSumProblem final : public Problem {
  public:
    DistanceSumProblem(Bounds bounds, Eigen::MatrixXd points)
        : bounds_(std::move(bounds)), points_(std::move(points)) {}

    [[nodiscard]] std::string name() const override { return "distance-sum"; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(Evaluation) const override { return true; }
    [[nodiscard]] bool has_kinks() const override { return true; }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override {
        const double sum = (points_.colwise() - x).colwise().norm().sum();
        return sum * sum;
    }
    [[nodiscard]] GradientEvaluation gradient(const Eigen::VectorXd& x, double smoothing) const override {
        const auto model = curvature(x, smoothing);
        return {model.objective, model.value, model.gradient};
    }
    [[nodiscard]] ResidualEvaluation residuals(const Eigen::VectorXd& x, double smoothing) const override {
        const auto model = curvature(x, smoothing);
        const double root = std::sqrt(model.value);
        return {model.objective, Eigen::VectorXd::Constant(1, root),
                model.gradient.transpose() / (2.0 * root)};
    }
    [[nodiscard]] CurvatureEvaluation curvature(const Eigen::VectorXd& x, double smoothing) const override {
        double sum = 0.0;
        Eigen::VectorXd slope = Eigen::VectorXd::Zero(x.size());
        Eigen::MatrixXd bend = Eigen::MatrixXd::Zero(x.size(), x.size());
        for (Eigen::Index q = 0; q < points_.cols(); ++q) {
            const Eigen::VectorXd d = x - points_.col(q);
            const double a = std::max(std::sqrt(d.squaredNorm() + smoothing * smoothing), 1e-300);
            sum += a;
            slope += d / a;
            bend += Eigen::MatrixXd::Identity(x.size(), x.size()) / a - d * d.transpose() / (a * a * a);
        }
        return {value(x), sum * sum, 2.0 * sum * slope, 2.0 * slope * slope.transpose() + 2.0 * sum * bend};
    }

  private:
    Bounds bounds_;
    Eigen::MatrixXd points_;
};

}  // namespace fretwork::optimization
