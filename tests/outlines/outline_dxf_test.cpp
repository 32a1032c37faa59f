// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/outlines/outline.hpp>

#include <numbers>

namespace fretwork::outlines {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

/// A file with a section ENTITIES: codes and values one after the other.
std::string dxf(const std::string& entities, const std::string& header = "") {
    std::string text = header + "0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF";
    std::replace(text.begin(), text.end(), ' ', '\n');
    return text + "\n";
}
constexpr const char* kInches = "0 SECTION 2 HEADER 9 $INSUNITS 70 1 0 ENDSEC ";
constexpr const char* kSquare = "0 LWPOLYLINE 90 4 70 1 10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10";

Outline read(const std::string& text) {
    const TemporaryFolder folder;
    return read_outline(folder.file("o.dxf", text));
}
std::string refuse(const std::string& text) {
    return refuse_file("o.dxf", text);
}

TEST(OutlineDxf, LinesArcsAndPolylinesJoinToClosedCurves) {
    const Outline outline = read_outline(data_file("slot.dxf"));  // in centimetres: 4 x 2, round ends, a hole
    ASSERT_EQ(outline.holes.size(), 1U);
    const double area = 4 * 2 + std::numbers::pi - std::numbers::pi / 4;
    EXPECT_NEAR(area_of(outline), area * 1e-4, 2e-5 * 0.2);  // tolerance of the flattening times the length
}

TEST(OutlineDxf, UnitsComeFromTheHeaderAndAreMillimetresWithoutOne) {
    EXPECT_NEAR(area_of(read(dxf(kSquare))), 1e-4, 1e-15);
    EXPECT_NEAR(area_of(read(dxf(kSquare, kInches))), 0.254 * 0.254, 1e-15);
    EXPECT_THAT(refuse(dxf(kSquare, "0 SECTION 2 HEADER 9 $INSUNITS 70 18 0 ENDSEC ")),
                HasSubstr("$INSUNITS is 18"));
}

TEST(OutlineDxf, APolylineMayBeOldAndHaveBulges) {
    const std::string lens =  // two half circles of radius 5
        "0 POLYLINE 66 1 10 0 20 0 70 1 0 VERTEX 10 0 20 0 42 1 0 VERTEX 10 10 20 0 42 1 0 SEQEND";
    EXPECT_NEAR(area_of(read(dxf(lens))), 25e-6 * std::numbers::pi, 2e-5 * 0.04);
    const std::string inward =  // a square of which a half circle is bitten off at the lower side
        "0 LWPOLYLINE 90 4 70 1 10 0 20 0 42 -1 10 10 20 0 10 10 20 10 10 0 20 10";
    EXPECT_NEAR(area_of(read(dxf(inward))), 100e-6 - 12.5e-6 * std::numbers::pi, 2e-5 * 0.04);
}

TEST(OutlineDxf, ComplaintsNameTheLine) {
    EXPECT_THAT(refuse(""), HasSubstr("no section ENTITIES"));
    EXPECT_THAT(refuse("0\n"), HasSubstr("line 1"));
    EXPECT_THAT(refuse("AutoCAD Binary DXF\nx\n"), HasSubstr("binary"));
    EXPECT_THAT(refuse(std::string("AutoCAD Binary DXF\r\n\x1a\0\0SECTION", 29)),
                HasSubstr("is a binary DXF file"));
    EXPECT_THAT(refuse("x\ny\n"), HasSubstr("ASCII"));
    EXPECT_THAT(refuse("0\nSECTION\n2\nENTITIES\n0\nLINE\n"), HasSubstr("ENDSEC"));
    EXPECT_THAT(refuse(dxf("0 LINE 10 0 20 0 11 1 21 0")),
                AllOf(HasSubstr("line 5"), HasSubstr("not closed")));
    EXPECT_THAT(refuse(dxf("0 LINE 10 0 20 0 11 1")), HasSubstr("no group 21"));
    EXPECT_THAT(refuse(dxf("0 CIRCLE 10 0 20 0 40 nan")), HasSubstr("'nan'"));
    EXPECT_THAT(refuse(dxf("0 CIRCLE 10 0 20 0 40 -1")), HasSubstr("radius -1"));
    EXPECT_THAT(refuse(dxf("0 SPLINE 70 8 71 3 10 0 20 0")),
                AllOf(HasSubstr("line 5"), HasSubstr("SPLINE"), HasSubstr("1 control points and 0 knots")));
    EXPECT_THAT(refuse(dxf("0 LWPOLYLINE 90 0 70 1")),
                HasSubstr("1 LWPOLYLINE of less than two points left out"));
    EXPECT_THAT(refuse(dxf("0 LWPOLYLINE 90 1000000000 70 1 10 0 20 0 10 1 20 0 10 1 20 1")),
                AllOf(HasSubstr("line 8"), HasSubstr("promises 1000000000 vertices, and has 3")));
    // dxflib 3.26.4 writes beyond its memory here: four times this number is 4 in 32 bits.
    EXPECT_THAT(refuse(dxf("0 LWPOLYLINE 90 1073741825 70 1 10 0 20 0 10 1 20 0 10 1 20 1")),
                HasSubstr("promises 1073741825 vertices"));
    EXPECT_THAT(refuse(dxf("0 LWPOLYLINE 90 2 70 1 10 0 20 0 10 1 20 0 10 5 20 5")),
                HasSubstr("promises 2 vertices, and has 3"));
    EXPECT_THAT(refuse(dxf("0 CIRCLE 10 0 20 0 40 1o")), HasSubstr("'1o'"));
    EXPECT_THAT(refuse(dxf("0 LWPOLYLINE 90 3 70 1e300 10 0 20 0 10 1 20 0 10 1 20 1")),
                HasSubstr("'1e300'"));
    EXPECT_THAT(refuse(dxf("0 POINT 10 0 20 0")), HasSubstr("no closed curve"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
