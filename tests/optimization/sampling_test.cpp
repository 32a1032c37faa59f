// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/sampling.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace fretwork::optimization {
namespace THIS_TEST {

TEST(LowDiscrepancySequence, SpreadsEveryProjectionMoreEvenlyThanChance) {
    constexpr int kPoints = 256;
    const LowDiscrepancySequence sequence(6, 11);
    for (int axis = 0; axis < 6; ++axis) {
        std::vector<double> shares;
        for (int n = 0; n < kPoints; ++n) shares.push_back(sequence.point(n)[axis]);
        std::ranges::sort(shares);
        double discrepancy = 0.0;
        for (int n = 0; n < kPoints; ++n) {
            discrepancy = std::max(discrepancy, std::abs(shares[n] - (n + 0.5) / kPoints));
        }
        // Uniform draws reach 0.03 in nineteen of twenty axes (Kolmogorov's distribution).
        EXPECT_LT(discrepancy, 0.025) << "axis " << axis;
    }
}

TEST(LowDiscrepancySequence, DependsOnSeedAndNumberOnly) {
    const LowDiscrepancySequence sequence(3, 5);
    EXPECT_EQ(sequence.point(9), LowDiscrepancySequence(3, 5).point(9));
    EXPECT_NE(sequence.point(9), LowDiscrepancySequence(3, 6).point(9));
    EXPECT_NE(sequence.point(9), sequence.point(10));
}

TEST(LowDiscrepancySequence, InOneDimensionStepsByTheGoldenRatio) {
    const LowDiscrepancySequence sequence(1, 5);
    const double step = sequence.point(1)[0] - sequence.point(0)[0];
    EXPECT_NEAR(step - std::floor(step), 0.6180339887498949, 1e-12);
}

}  // namespace THIS_TEST
}  // namespace fretwork::optimization
