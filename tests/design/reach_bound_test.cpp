// SPDX-License-Identifier: GPL-3.0-or-later
#include "trials_of.hpp"

#include <fretwork/design/reach/reach_bound.hpp>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fretwork::design::detail {
namespace THIS_TEST {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_stiffness(Eigen::Index size, base::SplitMix64& random) {
    MatrixXd factor(size, size);
    for (double& value : factor.reshaped()) value = random.share() - 0.5;
    return factor * factor.transpose() + 0.05 * MatrixXd::Identity(size, size);
}

double least_eigenvalue(const MatrixXd& matrix) {
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix).eigenvalues().minCoeff();
}

TEST(Enclosure, LiesBelowAndAboveAllMatrices) {
    base::SplitMix64 random(4);
    std::vector<MatrixXd> all;
    Enclosure enclosure;
    for (int i = 0; i < 12; ++i) {
        all.push_back(random_stiffness(6, random));
        enclosure.include(all.back());
    }
    EXPECT_GT(least_eigenvalue(enclosure.below), 0.0);
    for (const MatrixXd& own : all) {
        EXPECT_GT(least_eigenvalue(own - enclosure.below), -1e-10);
        EXPECT_GT(least_eigenvalue(enclosure.above - own), -1e-10);
    }
}

TEST(Enclosure, OfOneMatrixIsThatMatrix) {
    base::SplitMix64 random(5);
    const MatrixXd only = random_stiffness(5, random);
    Enclosure enclosure;
    enclosure.include(only);
    enclosure.include(only);
    EXPECT_LT((enclosure.below - only).norm(), 1e-12 * only.norm());
    EXPECT_LT((enclosure.above - only).norm(), 1e-12 * only.norm());
}

/// Closed form: an ellipsoid that is a ball of radius r sqrt(h).
TEST(DistanceToEllipsoid, OfABallIsTheDistanceFromItsMiddleLessItsRadius) {
    const VectorXd point = VectorXd::LinSpaced(4, 1.0, 2.0);
    EXPECT_NEAR(distance_to_ellipsoid(0.25 * MatrixXd::Identity(4, 4), 1.6, point), point.norm() - 0.8, 1e-9);
    EXPECT_EQ(distance_to_ellipsoid(MatrixXd::Identity(4, 4), 10.0, point), 0.0);
    EXPECT_NEAR(distance_to_ellipsoid(MatrixXd::Zero(4, 4), 1.0, point), point.norm(), 1e-12);
    const MatrixXd disc = Eigen::Vector3d(1.0, 1.0, 0.0).asDiagonal();
    EXPECT_NEAR(distance_to_ellipsoid(disc, 1.0, Eigen::Vector3d(0.5, 0.0, 5.0)), 5.0, 1e-12) << "flat";
}

/// Against the nearest of many points on the ellipse.
TEST(DistanceToEllipsoid, IsThatOfTheNearestPointOfAnEllipse) {
    MatrixXd shape(2, 2);
    shape << 2.0, 0.7, 0.7, 0.5;
    const MatrixXd root = shape.llt().matrixL();
    const Eigen::Vector2d point(1.5, -2.0);
    double nearest = 1e9;
    for (int i = 0; i < 100'000; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 100'000;
        nearest = std::min(nearest,
                           (root * Eigen::Vector2d(std::cos(angle), std::sin(angle)) * 0.9 - point).norm());
    }
    EXPECT_NEAR(distance_to_ellipsoid(shape, 0.9, point), nearest, 1e-6);
}

const std::vector<std::size_t> kPalette = {0, 1, 2, 3, 4};

/// In linear theory, to which the solved surfaces come near: 1e-3 is what they are off by.
TEST(ReachBound, IsBelowTheMisfitOfEveryPainting) {
    for (const double force : {2e-6, 1e-4, 6e-4}) {
        Trials trials = test::trials_of(test::cantilever_project(4, 3, force), test::bent(0.05));
        const auto bound = reach_bound(trials, kPalette, {});
        ASSERT_TRUE(bound);
        if (force < 2e-4) {
            EXPECT_GT(*bound, 0.1) << "no painting bends so far";
        }
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            const Trial trial = trials.solve(test::random_painting(trials, seed), {});
            ASSERT_TRUE(trial.is_found);
            EXPECT_LT(*bound, (1.0 + 1e-3) * std::sqrt(trial.objective)) << force;
        }
    }
}

TEST(ReachBound, ComesToOneWhereTheLoadIsFarTooSmall) {
    const Trials trials = test::trials_of(test::cantilever_project(4, 3, 1e-9), test::bent(0.05));
    // The misfit of standing still.
    const double still = std::sqrt(trials.scaled_objective(Trial{
        true,
        0.0,
        {mechanics::NodeValues::Zero(std::ssize(trials.parts().surface.tessellation.interface_nodes), 6)}}));
    const auto bound = reach_bound(trials, kPalette, {});
    ASSERT_TRUE(bound);
    EXPECT_LT(*bound, still * (1.0 + 1e-9));
    EXPECT_GT(*bound, 0.98 * still);
}

/// The answer of one painting of two patterns, all of which were in the enclosure.
TEST(ReachBound, SaysNothingAgainstWhatAPaintingReaches) {
    simulation::Project hidden = test::cantilever_project(4, 3, 2e-5);
    test::paint_graded(hidden, test::kDesignPatterns);
    const Trials trials = test::trials_of(hidden, test::target_of(hidden));
    const auto bound = reach_bound(trials, kPalette, {});
    ASSERT_TRUE(bound);
    EXPECT_LT(*bound, 1e-4);
}

TEST(ReachBound, IsNotKnownForLargeDisplacementsAndUnknowns) {
    EXPECT_FALSE(
        reach_bound(test::trials_of(test::cantilever_project(4, 3, 0.03), test::bent(3.0)), kPalette, {}));
    EXPECT_FALSE(reach_bound(test::trials_of(test::cantilever_project(4, 3, 2e-5), test::bent(0.05), {true}),
                             kPalette, {}));
}

}  // namespace THIS_TEST
}  // namespace fretwork::design::detail
