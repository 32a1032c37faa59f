// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "stops.hpp"

#include <fretwork/fabrication/narrow_places.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>

namespace fretwork::fabrication {
namespace THIS_TEST {

using namespace test;

TEST(NarrowPlaces, TheLargestCircleInATriangleIsItsIncircle) {
    const geometry::Polygon triangle = {{0.0, 0.0}, {4.0, 0.0}, {0.0, 3.0}};
    const InnerCircle circle = inner_circle(triangle);
    EXPECT_NEAR(circle.radius, 1.0, 0.011);  // the promise: a hundredth
    EXPECT_NEAR(circle.center.x, 1.0, 0.05);
    EXPECT_NEAR(circle.center.y, 1.0, 0.05);
}

TEST(NarrowPlaces, NoCircleFitsIntoAFlatPolygon) {
    EXPECT_EQ(inner_circle({{0.0, 0.0}, {1.0, 0.0}}).radius, 0.0);
}

TEST(NarrowPlaces, AThinOpeningIsFoundWithItsWidthTileAndNode) {
    // Two parallel bars, a fifth of a millimetre apart, joined at their ends.
    const double apart = kWidth + 2e-4;
    const BarPlan plan =
        plan_of({{0.0, 0.0}, {0.02, 0.0}, {0.02, apart}, {0.0, apart}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    const auto places = narrow_places(make_shape(plan, {}), plan, 5e-4);
    ASSERT_EQ(places.size(), 1U);
    EXPECT_EQ(places[0].kind, NarrowPlace::Kind::Opening);
    EXPECT_NEAR(places[0].width, 2e-4, 3e-6);
    EXPECT_EQ(places[0].tile, TileIndex(0));
    EXPECT_TRUE(places[0].node.is_valid());
    EXPECT_TRUE(narrow_places(make_shape(plan, {}), plan, 1e-4).empty());
}

TEST(NarrowPlaces, APlaceBetweenWideBarsHasItsTileAndNodeToo) {
    constexpr double kWide = 0.02;  // as of a frame
    const double apart = kWide + 2e-4;
    BarPlan plan =
        plan_of({{0.0, 0.0}, {0.1, 0.0}, {0.1, apart}, {0.0, apart}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    for (Bar& bar : plan.bars) bar.width = kWide;
    const auto places = narrow_places(make_shape(plan, {}), plan, 5e-4);
    ASSERT_FALSE(places.empty());
    EXPECT_EQ(places[0].tile, TileIndex(0));
    EXPECT_TRUE(places[0].node.is_valid());
}

TEST(NarrowPlaces, AGapBetweenAFreeEndAndABarIsFoundWhereItIs) {
    // A bar ends 0.3 mm before another one.
    const BarPlan plan =
        plan_of({{0.0, 0.0}, {0.02, 0.0}, {0.01, kWidth + 3e-4}, {0.01, 0.02}}, {{0, 1}, {2, 3}});
    const auto places = narrow_places(make_shape(plan, {}), plan, 5e-4);
    ASSERT_FALSE(places.empty());
    EXPECT_EQ(places[0].kind, NarrowPlace::Kind::Gap);
    EXPECT_NEAR(places[0].width, 3e-4, 2e-5);  // chords of the round end
    EXPECT_NEAR(places[0].place.x, 0.01, 5e-4);
    EXPECT_NEAR(places[0].place.y, 0.5 * kWidth + 1.5e-4, 2e-5);
    EXPECT_EQ(places[0].node, TessellationNodeIndex(2));
}

TEST(NarrowPlaces, TheSearchStopsAtAnyLook) {
    const simulation::Surface surface = honeycomb(3, 2, sample_patterns(2));
    const BarPlan plan = bar_plan(surface);
    const Shape shape = make_shape(plan, {});
    fretwork::test::expect_stops_at_any_look(
        [&](const base::Control& control) {
            (void)narrow_places(shape, plan, 5e-3, control);
            (void)simulation::close_bars(surface, 5e-3, control);
        },
        [] {});
}

TEST(NarrowPlaces, CornersAreNoGaps) {
    const BarPlan plan = plan_of({{0.0, 0.0}, {0.03, 0.0}, {0.0, 0.03}}, {{0, 1}, {1, 2}, {2, 0}});
    EXPECT_TRUE(narrow_places(make_shape(plan, {}), plan, 3e-3).empty());
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
