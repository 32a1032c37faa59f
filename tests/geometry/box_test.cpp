// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/box.hpp>

#include <gtest/gtest.h>

namespace fretwork::geometry {
namespace THIS_TEST {

TEST(Box, HasItsDiagonalBetweenOppositeCorners) {
    EXPECT_DOUBLE_EQ((Box{-1.0, 2.0, 2.0, 6.0}.diagonal()), 5.0);  // 3 m by 4 m
}

TEST(Box, HasItsMiddleHalfwayBetweenItsSides) {
    EXPECT_EQ((Box{-1.0, 2.0, 2.0, 6.0}.middle()), (Point2{0.5, 4.0}));
}

}  // namespace THIS_TEST
}  // namespace fretwork::geometry
