// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problems/least_squares_problem.hpp>

namespace fretwork::optimization {

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

/// Near 1 the objective falls to 0, near -1 to about 0.36.
inline LeastSquaresProblem two_valleys() {
    return {"two valleys", cube(1, -2.0, 2.0),
            [](const Eigen::VectorXd& x) {
                return Eigen::VectorXd(Eigen::Vector2d(x[0] * x[0] - 1.0, 0.3 * (x[0] - 1.0)));
            },
            [](const Eigen::VectorXd& x) { return Eigen::MatrixXd(Eigen::Vector2d(2.0 * x[0], 0.3)); }};
}

}  // namespace fretwork::optimization
