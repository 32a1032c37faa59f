// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/optimization/problems/analytic_problems.hpp>
#include <fretwork/optimization/problems/distance_sum_problem.hpp>

#include <gtest/gtest.h>

namespace fretwork::optimization {
namespace THIS_TEST {

Eigen::VectorXd random_point(const Bounds& bounds, base::RandomStream& random) {
    Eigen::VectorXd shares(bounds.dimension());
    for (double& share : shares) share = random.uniform();
    return bounds.at_shares(shares);
}

TEST(AnalyticProblems, HaveTheirKnownOptimumInsideAndNothingBelowIt) {
    base::RandomStream random(1, 0);
    for (const auto& [problem, best_value, best_point] : analytic_problems()) {
        EXPECT_TRUE(problem->bounds().contain(best_point)) << problem->name();
        EXPECT_NEAR(problem->value(best_point), best_value, 1e-12) << problem->name();
        const Eigen::VectorXd middle = (problem->bounds().lower + problem->bounds().upper) / 2.0;
        EXPECT_GT((best_point - middle).norm(), 0.1) << problem->name();
        for (int i = 0; i < 1000; ++i) {
            EXPECT_GT(problem->value(random_point(problem->bounds(), random)), best_value) << problem->name();
        }
    }
}

/// Central differences of everything that a problem differentiates.
TEST(AnalyticProblems, HaveTheDerivativesOfTheirValues) {
    base::RandomStream random(2, 0);
    for (const auto& [problem, best_value, best_point] : analytic_problems()) {
        const double smoothing = problem->has_kinks() ? 0.1 : 0.0;
        const Eigen::VectorXd x = random_point(problem->bounds(), random);
        const auto model = problem->curvature(x, smoothing);
        const auto residuals = problem->residuals(x, smoothing);
        EXPECT_NEAR(residuals.residuals.squaredNorm(), model.value, 1e-12 * (1.0 + model.value));
        EXPECT_EQ(model.objective, problem->value(x));
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const Eigen::VectorXd step = 1e-5 * Eigen::VectorXd::Unit(x.size(), i);
            const auto above = problem->residuals(x + step, smoothing).residuals;
            const auto below = problem->residuals(x - step, smoothing).residuals;
            const Eigen::VectorXd column = (above - below) / 2e-5;
            const double scale = 1.0 + residuals.jacobian.norm();
            EXPECT_LT((residuals.jacobian.col(i) - column).norm(), 1e-7 * scale) << problem->name();
            const double slope = (problem->curvature(x + step, smoothing).value -
                                  problem->curvature(x - step, smoothing).value) /
                                 2e-5;
            EXPECT_NEAR(model.gradient[i], slope, 1e-6 * (1.0 + model.gradient.norm())) << problem->name();
            EXPECT_NEAR(problem->gradient(x, smoothing).gradient[i], model.gradient[i],
                        1e-12 * (1.0 + model.gradient.norm()));
        }
    }
}

TEST(DistanceSumProblem, HasFiniteDerivativesAtAPointItself) {
    const Bounds bounds{Eigen::VectorXd::Constant(2, -1.0), Eigen::VectorXd::Constant(2, 1.0)};
    Eigen::MatrixXd points(2, 2);
    points << 0.5, -0.25, 0.25, 0.75;
    const Eigen::VectorXd x = points.col(0);
    for (int count = 1; count <= 2; ++count) {
        const DistanceSumProblem problem(bounds, points.leftCols(count));
        const auto residuals = problem.residuals(x, 0.0);
        EXPECT_EQ(residuals.jacobian.rows(), 1);
        EXPECT_TRUE(residuals.jacobian.allFinite()) << count;
        EXPECT_TRUE(problem.curvature(x, 0.0).curvature.allFinite()) << count;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::optimization
