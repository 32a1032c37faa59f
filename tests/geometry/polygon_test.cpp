// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/polygon.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace fretwork::geometry {
namespace THIS_TEST {

// The conventions: interface node i of the reference hexagon lies at angle 270 + 60 i degrees.
TEST(RegularPolygon, SideTHasItsMiddleAt270Plus360TOverSidesDegrees) {
    for (const int sides : {3, 4, 6, 7}) {
        const Polygon polygon = regular_polygon(sides, 0.03);
        ASSERT_EQ(polygon.size(), static_cast<std::size_t>(sides));
        for (int t = 0; t < sides; ++t) {
            const Point2 a = polygon[t];
            const Point2 b = polygon[(t + 1) % sides];
            const double angle = (1.5 + 2.0 * t / sides) * std::numbers::pi;
            const double distance = std::hypot(a.x + b.x, a.y + b.y) / 2;
            EXPECT_NEAR((a.x + b.x) / 2, distance * std::cos(angle), 1e-16);
            EXPECT_NEAR((a.y + b.y) / 2, distance * std::sin(angle), 1e-16);
            EXPECT_NEAR(std::hypot(b.x - a.x, b.y - a.y), 0.03, 1e-16);
        }
        EXPECT_TRUE(is_convex(polygon));
        EXPECT_NEAR(mean_side(polygon), 0.03, 1e-16);
    }
}

TEST(RegularPolygon, RefusesWhatIsNoPolygon) {
    EXPECT_THROW(regular_polygon(2, 1.0), base::InputError);
    EXPECT_EQ(regular_polygon(kMostPolygonSides, 1.0).size(), static_cast<std::size_t>(kMostPolygonSides));
    for (const int sides : {-1, kMostPolygonSides + 1, std::numeric_limits<int>::max()})
        EXPECT_THROW(regular_polygon(sides, 1.0), base::InputError) << sides;
    EXPECT_THROW(regular_polygon(6, 1e300), base::InputError);
    EXPECT_THROW(regular_polygon(6, 0.0), base::InputError);
    EXPECT_THROW(regular_polygon(6, -1.0), base::InputError);
    EXPECT_THROW(regular_polygon(6, std::numeric_limits<double>::quiet_NaN()), base::InputError);
    EXPECT_THROW(regular_polygon(6, std::numeric_limits<double>::infinity()), base::InputError);
}

TEST(SignedArea, IsPositiveCounterclockwise) {
    EXPECT_DOUBLE_EQ(signed_area({{0, 0}, {2, 0}, {2, 1}, {0, 1}}), 2.0);
    EXPECT_DOUBLE_EQ(signed_area({{0, 0}, {0, 1}, {2, 1}, {2, 0}}), -2.0);
}

// By hand: an L of three unit squares with centres (0.5, 0.5), (1.5, 0.5), (0.5, 1.5).
TEST(Centroid, IsThatOfTheAreaNotOfTheVertices) {
    const Point2 center = centroid({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
    EXPECT_NEAR(center.x, 2.5 / 3, 1e-15);
    EXPECT_NEAR(center.y, 2.5 / 3, 1e-15);
}

TEST(Centroid, KeepsItsDigitsFarFromTheOrigin) {
    const Point2 center = centroid({{1e6, 1e6}, {1e6 + 0.5, 1e6}, {1e6 + 0.5, 1e6 + 0.5}, {1e6, 1e6 + 0.5}});
    EXPECT_DOUBLE_EQ(center.x, 1e6 + 0.25);
    EXPECT_DOUBLE_EQ(center.y, 1e6 + 0.25);
}

TEST(Centroid, OfNoAreaIsRefused) {
    EXPECT_THROW(centroid({{0, 0}, {1, 1}, {2, 2}}), base::GeometryError);
}

TEST(IsConvex, AllowsStraightVertices) {
    EXPECT_TRUE(is_convex({{0, 0}, {1, 0}, {2, 0}, {1, 1}}));
}

TEST(IsConvex, IsDecidedExactly) {
    // The middle vertex leaves the line by one unit in the last place: below, the turn is left; above, right.
    const double below = std::nextafter(1.0, 0.0);
    const double above = std::nextafter(1.0, 2.0);
    EXPECT_TRUE(is_convex({{0, 1}, {1, below}, {2, 1}, {1, 2}}));
    EXPECT_FALSE(is_convex({{0, 1}, {1, above}, {2, 1}, {1, 2}}));
}

TEST(IsConvex, RefusesClockwiseReentrantDegenerateAndStarShaped) {
    EXPECT_FALSE(is_convex({{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
    EXPECT_FALSE(is_convex({{0, 0}, {2, 0}, {1, 0.2}, {1, 2}}));
    EXPECT_FALSE(is_convex({{0, 0}, {1, 0}, {2, 0}}));
    EXPECT_FALSE(is_convex({{0, 0}, {1, 0}}));
    EXPECT_FALSE(is_convex({{0, 0}, {1, 0}, {1, 0}, {0, 1}}));
    Polygon pentagram;
    for (int i = 0; i < 5; ++i)
        pentagram.push_back({std::cos(0.8 * std::numbers::pi * i), std::sin(0.8 * std::numbers::pi * i)});
    EXPECT_FALSE(is_convex(pentagram));
}

}  // namespace THIS_TEST
}  // namespace fretwork::geometry
