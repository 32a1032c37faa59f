// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/fabrication/solid.hpp>

namespace fretwork::fabrication {
namespace THIS_TEST {

using namespace test;
using testing::HasSubstr;

long openings_of(const Shape& shape) {
    long count = 0;
    for (const Piece& piece : shape.pieces) count += static_cast<long>(piece.openings.size());
    return count;
}

TEST(Solid, OfOneBarIsABallTopologicallyAndHasTheAreaTimesTheHeight) {
    const Shape shape = make_shape(plan_of({{0.0, 0.0}, {0.02, 0.0}}, {{0, 1}}), {});
    const Solid solid = make_solid(shape, {.chord_tolerance = 1e-7});
    EXPECT_EQ(check(solid).open_edges, 0U);
    EXPECT_EQ(check(solid).euler_number, 2);
    // Chords that are off by 1e-7 m at most, along two half circles of 1 mm.
    EXPECT_NEAR(volume(solid), area(shape) * shape.height, kPi * 2e-3 * 1e-7 * shape.height + 1e-15);
}

TEST(Solid, EveryEdgeHasTwoTrianglesInOppositeDirectionsOnManyPatterns) {
    for (const std::string& id : sample_patterns(40)) {
        const Shape shape = make_shape(honeycomb(2, 2, {id}), {.fillet = 5e-4, .frame_width = 3e-3});
        const Solid solid = make_solid(shape);
        const SolidCheck closed = check(solid);
        EXPECT_EQ(closed.open_edges, 0U) << id;
        EXPECT_EQ(closed.euler_number, 2 * static_cast<long>(shape.pieces.size()) - 2 * openings_of(shape))
            << id;
        EXPECT_NEAR(volume(solid), area(shape) * shape.height, 1e-3 * area(shape) * shape.height) << id;
    }
}

TEST(Solid, StandsOnThePlaneAndIsAsHighAsTheSheet) {
    const Shape shape = make_shape(star(4, 0.02), {});
    double low = 1.0, high = -1.0;
    for (const auto& vertex : make_solid(shape).vertices) {
        low = std::min(low, vertex[2]);
        high = std::max(high, vertex[2]);
    }
    EXPECT_DOUBLE_EQ(low, 0.0);
    EXPECT_DOUBLE_EQ(high, shape.height);
}

TEST(Solid, ACheckFindsAMissingTriangle) {
    Solid solid = make_solid(make_shape(star(3, 0.02), {}));
    solid.triangles.pop_back();
    EXPECT_EQ(check(solid).open_edges, 3U);
    std::swap(solid.triangles[0][0], solid.triangles[0][1]);
    EXPECT_GT(check(solid).open_edges, 3U);
}

TEST(Solid, AnOutlineThatTouchesItselfIsRefusedWithThePlace) {
    const geometry::Polygon left = {{0.0, 0.0}, {0.01, 0.01}, {0.0, 0.02}};
    const geometry::Polygon right = {{0.02, 0.0}, {0.02, 0.02}, {0.01, 0.01}};
    const Shape shape{{{straight({{-0.01, -0.01}, {0.03, -0.01}, {0.03, 0.03}, {-0.01, 0.03}}),
                        {reversed(straight(left)), reversed(straight(right))}}},
                      0.002};
    EXPECT_THAT(complaint_of([&] { (void)make_solid(shape); }), HasSubstr("(10, 10) mm"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
