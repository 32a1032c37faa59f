// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/design/search/search.hpp>
#include <fretwork/design/search/uniform_guess.hpp>

#include <gtest/gtest.h>

namespace fretwork::design::detail {
namespace THIS_TEST {

Eigen::MatrixXd random_places(Eigen::Index rows, Eigen::Index columns) {
    base::SplitMix64 random(5);
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.share(); });
}

/// Four points span three dimensions: nothing is lost.
TEST(UniformGuess, LeadingCoordinatesKeepTheDistancesOfFewPatterns) {
    const Eigen::MatrixXd logarithms = random_places(9, 4);
    const Eigen::MatrixXd found = leading_coordinates(logarithms);
    ASSERT_EQ(found.rows(), 3);
    for (Eigen::Index i = 0; i < 4; ++i) {
        for (Eigen::Index j = 0; j < i; ++j)
            EXPECT_NEAR((found.col(i) - found.col(j)).norm(), (logarithms.col(i) - logarithms.col(j)).norm(),
                        1e-12);
    }
    EXPECT_GE(found.row(0).squaredNorm(), found.row(1).squaredNorm());
    EXPECT_GE(found.row(1).squaredNorm(), found.row(2).squaredNorm());
}

TEST(UniformGuess, WeightsReproduceKnownValuesAndAffineOnes) {
    const Eigen::MatrixXd known = random_places(3, 6);
    for (Eigen::Index i = 0; i < known.cols(); ++i)
        EXPECT_LT((prediction_weights(known, known.col(i)) - Eigen::VectorXd::Unit(6, i)).norm(), 1e-9);
    const Eigen::Vector3d place(0.3, 0.9, 0.1);
    const Eigen::VectorXd weights = prediction_weights(known, place);
    EXPECT_NEAR(weights.sum(), 1.0, 1e-12);
    EXPECT_NEAR(weights.dot(known.row(0)), place[0], 1e-12);
}

TEST(UniformGuess, TwoKnownPlacesGiveAStraightLine) {
    Eigen::MatrixXd known(1, 2);
    known << 1.0, 3.0;
    const Eigen::VectorXd weights = prediction_weights(known, Eigen::VectorXd::Constant(1, 4.0));
    EXPECT_NEAR(weights[0], -0.5, 1e-12);
    EXPECT_NEAR(weights[1], 1.5, 1e-12);
}

TEST(SolutionLimit, IsLargerForFewTilesUnlessItIsGiven) {
    EXPECT_EQ(solution_limit({}, 2000), 40);
    EXPECT_EQ(solution_limit({}, 44), 40);
    EXPECT_EQ(solution_limit({}, 22), 80);
    EXPECT_EQ(solution_limit({}, 1), 320);
    DesignOptions options;
    options.most_solutions = 12;
    EXPECT_EQ(solution_limit(options, 1), 12);
}

}  // namespace THIS_TEST
}  // namespace fretwork::design::detail
