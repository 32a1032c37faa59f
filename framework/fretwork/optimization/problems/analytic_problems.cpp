// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/problems/analytic_problems.hpp>
#include <fretwork/optimization/problems/distance_sum_problem.hpp>
#include <fretwork/optimization/problems/least_squares_problem.hpp>

#include <cmath>
#include <numbers>

namespace fretwork::optimization {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;

Bounds cube(int dimension, double low, double high) {
    return {VectorXd::Constant(dimension, low), VectorXd::Constant(dimension, high)};
}

AnalyticProblem sphere(int n) {
    const VectorXd center = VectorXd::LinSpaced(n, 0.1, 0.1 * n);
    return {std::make_unique<LeastSquaresProblem>(
                "sphere", cube(n, -2.0, 3.0), [=](const VectorXd& x) { return (x - center).eval(); },
                [=](const VectorXd&) { return MatrixXd::Identity(n, n).eval(); }),
            0.0, center};
}

VectorXd rosenbrock_residuals(const VectorXd& x) {
    VectorXd r(2 * (x.size() - 1));
    for (Index i = 0; i + 1 < x.size(); ++i) {
        r[2 * i] = 10.0 * (x[i + 1] - x[i] * x[i]);
        r[2 * i + 1] = 1.0 - x[i];
    }
    return r;
}

MatrixXd rosenbrock_jacobian(const VectorXd& x) {
    MatrixXd J = MatrixXd::Zero(2 * (x.size() - 1), x.size());
    for (Index i = 0; i + 1 < x.size(); ++i) {
        J(2 * i, i) = -20.0 * x[i];
        J(2 * i, i + 1) = 10.0;
        J(2 * i + 1, i) = -1.0;
    }
    return J;
}

AnalyticProblem rosenbrock(int n) {
    return {std::make_unique<LeastSquaresProblem>("rosenbrock", cube(n, -2.0, 2.0), rosenbrock_residuals,
                                                  rosenbrock_jacobian),
            0.0, VectorXd::Ones(n)};
}

/// The Hessian is singular at the minimum [Powell1962].
AnalyticProblem powell_singular() {
    return {std::make_unique<LeastSquaresProblem>(
                "powell-singular", cube(4, -4.0, 5.0),
                [](const VectorXd& x) {
                    return VectorXd(Eigen::Vector4d(x[0] + 10.0 * x[1], std::sqrt(5.0) * (x[2] - x[3]),
                                                    std::pow(x[1] - 2.0 * x[2], 2),
                                                    std::sqrt(10.0) * std::pow(x[0] - x[3], 2)));
                },
                [](const VectorXd& x) {
                    const double a = 2.0 * (x[1] - 2.0 * x[2]);
                    const double b = 2.0 * std::sqrt(10.0) * (x[0] - x[3]);
                    MatrixXd J(4, 4);
                    J << 1.0, 10.0, 0.0, 0.0, 0.0, 0.0, std::sqrt(5.0), -std::sqrt(5.0), 0.0, a, -2.0 * a,
                        0.0, b, 0.0, 0.0, -b;
                    return J;
                }),
            0.0, VectorXd::Zero(4)};
}

AnalyticProblem beale() {
    return {std::make_unique<LeastSquaresProblem>(
                "beale", cube(2, -4.5, 4.5),
                [](const VectorXd& x) {
                    const double y = x[1];
                    return VectorXd(Eigen::Vector3d(1.5 - x[0] * (1.0 - y), 2.25 - x[0] * (1.0 - y * y),
                                                    2.625 - x[0] * (1.0 - y * y * y)));
                },
                [](const VectorXd& x) {
                    const double y = x[1];
                    MatrixXd J(3, 2);
                    J << y - 1.0, x[0], y * y - 1.0, 2.0 * x[0] * y, y * y * y - 1.0, 3.0 * x[0] * y * y;
                    return J;
                }),
            0.0, Eigen::Vector2d(3.0, 0.5)};
}

/// x^2 + 10 (1 - cos(2 pi x)) = x^2 + 20 sin(pi x)^2, summed: a minimum near every integer point.
AnalyticProblem rastrigin(int n) {
    const double root = std::sqrt(20.0);
    return {std::make_unique<LeastSquaresProblem>(
                "rastrigin", cube(n, -3.2, 4.4),
                [=](const VectorXd& x) {
                    VectorXd r(2 * n);
                    r << x, root * (kPi * x.array()).sin().matrix();
                    return r;
                },
                [=](const VectorXd& x) {
                    MatrixXd J(2 * n, n);
                    J << MatrixXd::Identity(n, n),
                        MatrixXd((root * kPi * (kPi * x.array()).cos()).matrix().asDiagonal());
                    return J;
                }),
            0.0, VectorXd::Zero(n)};
}

/// sin(pi w_1)^2 + sum (w_i - 1)^2 (1 + 10 sin(pi w_i + 1)^2) + (w_n - 1)^2 (1 + sin(2 pi w_n)^2), with the
/// sum over i = 1 .. n - 1 and w = 1 + (x - 1) / 4 [LevyMontalvo1985].
class Levy {
  public:
    static VectorXd residuals(const VectorXd& x) {
        const VectorXd w = 1.0 + (x.array() - 1.0) / 4.0;
        const Index n = x.size();
        VectorXd r(2 * n + 1);
        r[2 * n] = std::sin(kPi * w[0]);
        for (Index i = 0; i < n; ++i) {
            r[2 * i] = w[i] - 1.0;
            r[2 * i + 1] = (w[i] - 1.0) * factor(i, n) * std::sin(phase(i, n, w[i]));
        }
        return r;
    }
    static MatrixXd jacobian(const VectorXd& x) {
        const VectorXd w = 1.0 + (x.array() - 1.0) / 4.0;
        const Index n = x.size();
        MatrixXd J = MatrixXd::Zero(2 * n + 1, n);
        J(2 * n, 0) = kPi * std::cos(kPi * w[0]);
        for (Index i = 0; i < n; ++i) {
            const double angle = phase(i, n, w[i]);
            const double rate = i + 1 < n ? kPi : 2.0 * kPi;
            J(2 * i, i) = 1.0;
            J(2 * i + 1, i) = factor(i, n) * (std::sin(angle) + (w[i] - 1.0) * rate * std::cos(angle));
        }
        return J / 4.0;
    }

  private:
    static double factor(Index i, Index n) { return i + 1 < n ? std::sqrt(10.0) : 1.0; }
    static double phase(Index i, Index n, double w) { return i + 1 < n ? kPi * w + 1.0 : 2.0 * kPi * w; }
};

AnalyticProblem levy(int n) {
    return {
        std::make_unique<LeastSquaresProblem>("levy", cube(n, -8.0, 9.0), Levy::residuals, Levy::jacobian),
        0.0, VectorXd::Ones(n)};
}

/// The triangle's angle at its first corner is wider than 120 degrees, so the sum of distances is least
/// there.
AnalyticProblem distance_sum() {
    MatrixXd corners(2, 3);
    corners << 0.0, 2.0, -2.0, 0.0, 0.3, 0.3;
    auto problem = std::make_unique<DistanceSumProblem>(
        Bounds{Eigen::Vector2d(-3.0, -2.0), Eigen::Vector2d(2.0, 4.0)}, corners);
    const VectorXd corner = VectorXd::Zero(2);
    const double best = 4.0 * (2.0 * 2.0 + 0.3 * 0.3);
    return {std::move(problem), best, corner};
}

}  // namespace

std::vector<AnalyticProblem> analytic_problems() {
    std::vector<AnalyticProblem> problems;
    problems.push_back(sphere(6));
    problems.push_back(rosenbrock(6));
    problems.push_back(powell_singular());
    problems.push_back(beale());
    problems.push_back(rastrigin(4));
    problems.push_back(levy(4));
    problems.push_back(distance_sum());
    return problems;
}

}  // namespace fretwork::optimization
