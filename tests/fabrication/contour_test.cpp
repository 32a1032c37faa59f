// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/contour.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace fretwork::fabrication {
namespace THIS_TEST {

using geometry::Box;

constexpr double kPi = std::numbers::pi;

/// A stadium: two half circles of radius 1 on two sides of a square of side 2.
Contour stadium() {
    return {{{-1.0, -1.0}, 0.0}, {{1.0, -1.0}, 1.0}, {{1.0, 1.0}, 0.0}, {{-1.0, 1.0}, 1.0}};
}

TEST(Contour, AreaAndLengthOfACircleAreExact) {
    const Contour whole = circle({3.0, -2.0}, 0.5);
    EXPECT_NEAR(signed_area(whole), kPi / 4.0, 1e-15);
    EXPECT_NEAR(length(whole), kPi, 1e-15);
}

TEST(Contour, AreaAndLengthOfAStadiumAreExact) {
    EXPECT_NEAR(signed_area(stadium()), 4.0 + kPi, 1e-14);
    EXPECT_NEAR(length(stadium()), 4.0 + 2.0 * kPi, 1e-14);
}

TEST(Contour, TheOtherDirectionHasTheOppositeAreaAndTheSameLength) {
    const Contour other = reversed(stadium());
    EXPECT_NEAR(signed_area(other), -(4.0 + kPi), 1e-14);
    EXPECT_NEAR(length(other), length(stadium()), 1e-14);
}

TEST(Contour, ABulgeIsTheTangentOfAQuarterOfTheAngle) {
    for (const double angle : {0.1, 1.0, 3.0, -2.0}) {
        const ContourPoint from{{std::cos(0.3), std::sin(0.3)}, std::tan(angle / 4.0)};
        const Arc arc = arc_between(from, {std::cos(0.3 + angle), std::sin(0.3 + angle)});
        EXPECT_NEAR(arc.radius, 1.0, 1e-13) << angle;
        EXPECT_NEAR(arc.center.x, 0.0, 1e-13) << angle;
        EXPECT_NEAR(arc.center.y, 0.0, 1e-13) << angle;
        EXPECT_NEAR(arc.sweep, angle, 1e-14) << angle;
    }
}

TEST(Contour, ChordsAreOffByNoMoreThanTheTolerance) {
    const Contour whole = circle({0.0, 0.0}, 1.0);
    for (const double tolerance : {0.1, 1e-2, 1e-4}) {
        const geometry::Polygon polygon = flattened(whole, tolerance);
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const auto& a = polygon[i];
            const auto& b = polygon[(i + 1) % polygon.size()];
            EXPECT_GE(std::hypot(0.5 * (a.x + b.x), 0.5 * (a.y + b.y)), 1.0 - tolerance - 1e-12);
        }
        EXPECT_LE(geometry::signed_area(polygon), kPi);
    }
}

TEST(Contour, ItsBoxHoldsTheArcs) {
    const Box box = box_of(stadium());
    EXPECT_NEAR(box.xmin, -2.0, 1e-15);
    EXPECT_NEAR(box.xmax, 2.0, 1e-15);
    EXPECT_NEAR(box.ymin, -1.0, 1e-15);
    EXPECT_NEAR(box.ymax, 1.0, 1e-15);
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
