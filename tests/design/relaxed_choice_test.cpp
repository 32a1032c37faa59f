// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/design/swaps/relaxed_choice.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace fretwork::design::detail {
namespace THIS_TEST {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

SwapTable table_of(const VectorXd& residual, std::vector<MatrixXd> responses) {
    SwapTable table;
    table.residual = residual;
    table.energies.setZero(responses.front().cols(), std::ssize(responses));
    table.masses = table.energies;
    table.responses = std::move(responses);
    table.by_unknowns.resize(residual.size(), 0);
    return table;
}

SwapTable random_table(Index rows, Index groups, Index columns) {
    base::SplitMix64 random(4);
    const auto matrix = [&](Index r, Index c) {
        MatrixXd values(r, c);
        for (double& value : values.reshaped()) value = random.share() - 0.5;
        return values;
    };
    std::vector<MatrixXd> responses;
    for (Index g = 0; g < groups; ++g) responses.push_back(matrix(rows, columns));
    return table_of(3.0 * matrix(rows, 1), std::move(responses));
}

/// Between (1, 0) and (0, 1) the point nearest to the origin is the middle.
TEST(RelaxedChoice, IsThePointOfASegmentThatIsNearest) {
    MatrixXd responses(2, 2);
    responses << 1.0, 0.0, 0.0, 1.0;
    SwapTable table = table_of(Vector2d::Zero(), {responses});
    table.unreached = 0.25;
    const RelaxedChoice choice = relaxed_choice(table, {0}, {});
    EXPECT_NEAR(choice.objective, 0.75, 1e-12);
    EXPECT_NEAR(choice.weights.front()[0], 0.5, 1e-12);
}

/// Within 1 % of its own lower bound, and that bound is below each of the 4^5 choices.
TEST(RelaxedChoice, HasABoundBelowEveryChoice) {
    const SwapTable table = random_table(12, 5, 4);
    const RelaxedChoice choice = relaxed_choice(table, {0, 1, 2, 3, 0}, {});
    EXPECT_GE(choice.gap, 0.0);
    EXPECT_LE(choice.gap, 0.01 * choice.objective);
    double least = std::numeric_limits<double>::infinity();
    for (int number = 0; number < 1024; ++number) {
        VectorXd residual = table.residual;
        for (int g = 0, rest = number; g < 5; ++g, rest /= 4)
            residual += table.responses[static_cast<std::size_t>(g)].col(rest % 4);
        least = std::min(least, residual.squaredNorm());
    }
    EXPECT_LE(choice.objective, least);
    VectorXd residual = table.residual;
    for (std::size_t g = 0; g < 5; ++g) {
        EXPECT_NEAR(choice.weights[g].sum(), 1.0, 1e-12);
        EXPECT_GE(choice.weights[g].minCoeff(), 0.0);
        residual += table.responses[g] * choice.weights[g];
    }
    EXPECT_NEAR(residual.squaredNorm(), choice.objective, 1e-9);
}

/// The part of the residuals that a continuous unknown can remove does not count.
TEST(RelaxedChoice, LeavesToUnknownsWhatTheyCanDo) {
    SwapTable table = random_table(12, 5, 4);
    const double without = relaxed_choice(table, {0, 0, 0, 0, 0}, {}).objective;
    table.by_unknowns = table.residual;
    table.largest_steps = VectorXd::Ones(1);
    EXPECT_LT(relaxed_choice(table, {0, 0, 0, 0, 0}, {}).objective, 0.9 * without);
}

}  // namespace THIS_TEST
}  // namespace fretwork::design::detail
