// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/nearly_convex.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace fretwork::geometry {
namespace THIS_TEST {

/// A square of side 2 with the middles of its sides as vertices; the lowest lies inside by `depth`.
Polygon dented(double depth) {
    return {{0, 0}, {1, depth}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
}

TEST(IsNearlyConvex, AllowsStraightCornersThatRoundingBendsInwards) {
    EXPECT_TRUE(is_nearly_convex(dented(0.0)));
    EXPECT_TRUE(is_nearly_convex(dented(-0.1)));
    EXPECT_FALSE(is_convex(dented(1e-17)));
    EXPECT_TRUE(is_nearly_convex(dented(1e-17)));
    EXPECT_TRUE(is_nearly_convex(dented(0.9 * kInwardTolerance)));
    EXPECT_FALSE(is_nearly_convex(dented(1.1 * kInwardTolerance)));
}

TEST(IsNearlyConvex, AllowsStraightCornersAtEveryAngleAndRounding) {
    for (int turn = 0; turn < 360; ++turn) {
        for (const double digits : {1e6, 1e9, 1e16}) {
            Polygon turned = dented(0.0);
            for (Point2& point : turned) {
                const double x = std::cos(turn) * point.x - std::sin(turn) * point.y;
                const double y = std::sin(turn) * point.x + std::cos(turn) * point.y;
                point = {std::round(x * digits) / digits, std::round(y * digits) / digits};
            }
            EXPECT_TRUE(is_nearly_convex(turned)) << turn << ", " << digits;
        }
    }
}

TEST(IsNearlyConvex, SeveralVerticesOfOneSideMayBendInwards) {
    EXPECT_TRUE(is_nearly_convex({{0, 0}, {1, 1e-7}, {2, 3e-7}, {3, 1e-7}, {4, 0}, {4, 3}, {0, 3}}));
    EXPECT_TRUE(is_nearly_convex({{0, 0}, {1, 3e-7}, {2, 1e-7}, {3, 3e-7}, {4, 0}, {4, 3}, {0, 3}}));
}

TEST(IsNearlyConvex, RefusesClockwiseReentrantDegenerateAndSpikes) {
    EXPECT_FALSE(is_nearly_convex({{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
    EXPECT_FALSE(is_nearly_convex({{0, 0}, {2, 0}, {1, 0.2}, {1, 2}}));
    EXPECT_FALSE(is_nearly_convex({{0, 0}, {1, 0}, {2, 0}}));
    EXPECT_FALSE(is_nearly_convex({{0, 0}, {1, 1e-17}, {2, 0}, {3, 0}}));
    EXPECT_FALSE(is_nearly_convex({{0, 0}, {1, 0}, {1, 0}, {0, 1}}));
    EXPECT_FALSE(is_nearly_convex({{0, 0}, {3, 0}, {2, 0}, {4, 1}, {0, 3}})) << "there and back";
}

TEST(InwardBend, IsToldWithItsPlaceAndDepth) {
    EXPECT_EQ(inward_bend_text(dented(0.25)), ": it bends inwards at (1, 0.25) by 0.25 m");
    EXPECT_EQ(inward_bend_text(dented(0.0)), "");
    EXPECT_EQ(inward_bend_text({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), "") << "clockwise";
}

}  // namespace THIS_TEST
}  // namespace fretwork::geometry
