// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/fabrication/sheets.hpp>

namespace fretwork::fabrication {
namespace THIS_TEST {

using geometry::Box;

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

simulation::Surface wide_surface() {
    return honeycomb(8, 4, {"1-6+3-6", "0-1+1-6"});  // some 330 x 200 mm
}

double material(const CutSheet& sheet) {
    return area({sheet.pieces, 0.0});
}

TEST(Sheets, ASurfaceThatFitsTheBedIsOnePartWithoutJoints) {
    const SheetSet set = cut_into_sheets(wide_surface(), {}, {.width = 0.6, .height = 0.4});
    EXPECT_EQ(set.sheets.size(), 1U);
    EXPECT_EQ(set.parts, 1U);
    EXPECT_EQ(set.connectors, 0U);
    EXPECT_NEAR(material(set.sheets[0]), area(make_shape(wide_surface())), 1e-9);
}

TEST(Sheets, PartsLieOnTheBedWithinItsMargins) {
    const Bed bed{.width = 0.2, .height = 0.15};
    const SheetSet set = cut_into_sheets(wide_surface(), {}, bed);
    EXPECT_GT(set.parts, 3U);
    EXPECT_GT(set.connectors, 5U);
    for (const CutSheet& sheet : set.sheets) {
        const Box box = box_of(sheet);
        EXPECT_GE(box.xmin, bed.margin - 1e-9);
        EXPECT_GE(box.ymin, bed.margin - 1e-9);
        EXPECT_LE(box.xmax, bed.width - bed.margin + 1e-9);
        EXPECT_LE(box.ymax, bed.height - bed.margin + 1e-9);
    }
}

TEST(Sheets, AWideFrameLiesOnTheBedToo) {
    const Bed bed{.width = 0.2, .height = 0.15};
    const SheetSet set = cut_into_sheets(wide_surface(), {.frame_width = 0.02}, bed);
    for (const CutSheet& sheet : set.sheets) {
        const Box box = box_of(sheet);
        EXPECT_GE(std::min(box.xmin, box.ymin), bed.margin - 1e-9);
        EXPECT_LE(box.xmax, bed.width - bed.margin + 1e-9);
        EXPECT_LE(box.ymax, bed.height - bed.margin + 1e-9);
    }
}

TEST(Sheets, PartsOnASheetDoNotOverlap) {
    const SheetSet set = cut_into_sheets(wide_surface(), {}, {.width = 0.2, .height = 0.15});
    for (const CutSheet& sheet : set.sheets) {
        for (std::size_t i = 0; i < sheet.pieces.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(box_of(sheet.pieces[i].outer).meets(box_of(sheet.pieces[j].outer)));
    }
}

TEST(Sheets, EachPartIsOnePiece) {
    const SheetSet set = cut_into_sheets(wide_surface(), {}, {.width = 0.2, .height = 0.15});
    std::size_t pieces = 0;
    for (const CutSheet& sheet : set.sheets) pieces += sheet.pieces.size();
    EXPECT_EQ(pieces, set.parts);
}

TEST(Sheets, JointsLeaveTheFitAroundKnobsAndNothingElseIsLost) {
    // Two tiles, two parts, one joint. All of the surface and the joint's two half plates is there but the
    // gap of the fit: along the seam, the neck and the knob.
    const simulation::Surface surface = honeycomb(1, 2, {"1-6+3-6"});
    const Bed bed{.width = 0.0704, .height = 0.0704, .margin = 1e-3, .fit = 1e-4};
    const SheetSet set = cut_into_sheets(surface, {}, bed);
    ASSERT_EQ(set.parts, 2U);
    ASSERT_EQ(set.connectors, 1U);
    double sum = 0.0;
    for (const CutSheet& sheet : set.sheets) sum += material(sheet);
    const SheetSet tight =
        cut_into_sheets(surface, {}, {.width = 0.0704, .height = 0.0704, .margin = 1e-3, .fit = 0.0});
    double tight_sum = 0.0;
    for (const CutSheet& sheet : tight.sheets) tight_sum += material(sheet);
    const double plate = 3.4 * kWidth;
    const double knob_angle = std::asin(0.5 / 0.9);  // half of what the neck takes of the knob
    const double neck_length = 1.5 * kWidth - 0.9 * kWidth * std::cos(knob_angle);
    const double gap = 2.0 * plate - kWidth + 2.0 * neck_length + 0.9 * kWidth * 2.0 * (kPi - knob_angle);
    EXPECT_NEAR(tight_sum - sum, gap * 1e-4, 0.05 * gap * 1e-4);  // corners of the gap
}

TEST(Sheets, ATileThatDoesNotFitTheBedIsNamed) {
    EXPECT_THAT(
        complaint_of([] { (void)cut_into_sheets(wide_surface(), {}, {.width = 0.04, .height = 0.04}); }),
        AllOf(HasSubstr("tile 0"), HasSubstr("bed")));
}

TEST(Sheets, AJointWithoutRoomIsNamedByItsNode) {
    simulation::Surface surface = wide_surface();
    surface.setting.section = mechanics::rectangle_section(0.0045, 0.002);
    EXPECT_THAT(complaint_of([&] { (void)cut_into_sheets(surface, {}, {.width = 0.2, .height = 0.15}); }),
                AllOf(HasSubstr("node"), HasSubstr("no room")));
}

TEST(Sheets, SideBySideHasAllSheetsAndTheAssembly) {
    const Bed bed{.width = 0.2, .height = 0.15};
    const SheetSet set = cut_into_sheets(wide_surface(), {}, bed);
    const CutSheet all = side_by_side(set, bed);
    double sum = 0.0;
    for (const CutSheet& sheet : set.sheets) sum += material(sheet);
    EXPECT_NEAR(material(all), sum, 1e-12);
    EXPECT_EQ(all.guides.size(), set.assembly.guides.size() + set.sheets.size());
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
