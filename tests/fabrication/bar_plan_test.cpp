// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

namespace fretwork::fabrication {
namespace THIS_TEST {

using geometry::Point2;

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

TEST(BarPlan, HasTheWidthAndHeightOfTheSettingsRectangle) {
    simulation::Surface surface = honeycomb(1, 1, {"1-6+3-6"});
    surface.setting.section = mechanics::rectangle_section(0.003, 0.0015);
    const BarPlan plan = bar_plan(surface);
    EXPECT_NEAR(plan.width, 0.003, 1e-15);
    EXPECT_NEAR(plan.height, 0.0015, 1e-15);
    EXPECT_EQ(plan.bars.size(), simulation::surface_fan(surface).edges.size());
}

TEST(BarPlan, AFrameRunsAlongTheRimAndNowhereElse) {
    const simulation::Surface surface = honeycomb(2, 1, {"1-6+3-6"});
    const BarPlan plan = bar_plan(surface, 0.004);
    double length = 0.0;
    for (const Bar& bar : plan.bars) {
        if (bar.width != 0.004) continue;
        const Point2& a = plan.nodes[bar.nodes[0]];
        const Point2& b = plan.nodes[bar.nodes[1]];
        length += std::hypot(b.x - a.x, b.y - a.y);
    }
    EXPECT_NEAR(length, 10.0 * kSide, 1e-12);  // two hexagons with one side in common
}

TEST(BarPlan, ATileThatIsNotPaintedIsRefusedByName) {
    simulation::Surface surface = honeycomb(2, 2, {"1-6+3-6"});
    surface.tessellation.tiles[2].pattern = -1;
    EXPECT_THAT(complaint_of([&] { (void)bar_plan(surface); }),
                AllOf(HasSubstr("tile 2"), HasSubstr("painted")));
}

TEST(BarPlan, ATileThatDoesNotCloseIsRefusedByName) {
    simulation::Surface surface = honeycomb(2, 2, {"1-6+3-6"});
    std::swap(surface.tessellation.tiles[3].vertices[1], surface.tessellation.tiles[3].vertices[3]);
    EXPECT_THAT(complaint_of([&] { (void)bar_plan(surface); }), HasSubstr("tile 3"));
}

TEST(BarPlan, BarsWithoutWidthAreRefused) {
    simulation::Surface surface = honeycomb(1, 1, {"1-6+3-6"});
    surface.setting.section.I3 = 0.0;
    EXPECT_THAT(complaint_of([&] { (void)bar_plan(surface); }), HasSubstr("no width"));
    surface.setting.section = {};
    EXPECT_THAT(complaint_of([&] { (void)bar_plan(surface); }), HasSubstr("no width"));
}

TEST(BarPlan, BeamsThatCrossAreRefusedWithTileAndPlace) {
    const std::string complaint = complaint_of([] { (void)bar_plan(honeycomb(1, 1, {"0-6+1-3+1-6"})); });
    EXPECT_THAT(complaint, AllOf(HasSubstr("tile 0"), HasSubstr("cross"), HasSubstr("mm")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
