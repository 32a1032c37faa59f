// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace fretwork::base {
namespace THIS_TEST {

// Known answers of Philox4x32-10, from the kat_vectors of Random123 [Salmon2011].
TEST(Philox, GivesTheKnownAnswersOfItsAuthors) {
    using Words = std::array<std::uint32_t, 4>;
    EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
              (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
              (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomStream, RepeatsItselfAndDiffersBySeedAndStream) {
    const auto first_of = [](std::uint64_t seed, std::uint64_t stream) {
        return RandomStream(seed, stream).uniform();
    };
    EXPECT_EQ(first_of(1, 2), first_of(1, 2));
    EXPECT_NE(first_of(1, 2), first_of(1, 3));
    EXPECT_NE(first_of(1, 2), first_of(2, 2));
}

TEST(RandomStream, IsUniformInTheOpenInterval) {
    constexpr int kDraws = 20000;
    RandomStream random(3, 0);
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        const double u = random.uniform();
        ASSERT_GT(u, 0.0);
        ASSERT_LT(u, 1.0);
        sum += u;
        squares += u * u;
    }
    // Five standard deviations of the sample means: sqrt(1/12/n) and sqrt(4/45/n).
    EXPECT_NEAR(sum / kDraws, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kDraws));
    EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / kDraws));
}

TEST(RandomStream, LaplaceHasMeanZeroAndTheGivenMeanSize) {
    constexpr int kDraws = 20000;
    RandomStream random(4, 0);
    double sum = 0.0;
    double sizes = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        const double x = random.laplace(0.7);
        sum += x;
        sizes += std::abs(x);
    }
    // |x| is exponential with mean and deviation 0.7; x has deviation 0.7 sqrt(2). Five deviations.
    EXPECT_NEAR(sum / kDraws, 0.0, 5.0 * 0.7 * std::sqrt(2.0 / kDraws));
    EXPECT_NEAR(sizes / kDraws, 0.7, 5.0 * 0.7 * std::sqrt(1.0 / kDraws));
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
