// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings as drafting programs make them: blocks, layers, splines, gaps.
#include "outlines/outlines.hpp"

#include <fretwork/outlines/outline.hpp>

#include <numbers>

namespace fretwork::outlines {
namespace THIS_TEST {

using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kPi = std::numbers::pi;

struct Sections {
    std::string entities;
    std::string layers;
    std::string blocks;
};

/// Codes and values one after the other become a file in millimetres.
OutlineFile read(const Sections& sections) {
    std::string text = "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 TABLES " + sections.layers +
                       " 0 ENDSEC 0 SECTION 2 BLOCKS " + sections.blocks + " 0 ENDSEC 0 SECTION 2 ENTITIES " +
                       sections.entities + " 0 ENDSEC 0 EOF";
    text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return a == ' ' && b == ' '; }),
               text.end());
    std::replace(text.begin(), text.end(), ' ', '\n');
    const TemporaryFolder folder;
    return read_outline_file(folder.file("o.dxf", text + "\n"));
}
OutlineFile read(const std::string& entities) {
    return read(Sections{entities, "", ""});
}
/// Square millimetres.
double area(const OutlineFile& file) {
    double sum = 0;
    for (const Outline& part : file.parts) sum += 1e6 * area_of(part);
    return sum;
}
std::string number(double value) {
    return std::to_string(value);
}
std::string line(double x1, double y1, double x2, double y2) {
    return "0 LINE 8 0 10 " + number(x1) + " 20 " + number(y1) + " 11 " + number(x2) + " 21 " + number(y2) +
           " ";
}
std::string rectangle(double x, double y, double width, double height, const std::string& layer = "0") {
    return "0 LWPOLYLINE 8 " + layer + " 90 4 70 1 10 " + number(x) + " 20 " + number(y) + " 10 " +
           number(x + width) + " 20 " + number(y) + " 10 " + number(x + width) + " 20 " + number(y + height) +
           " 10 " + number(x) + " 20 " + number(y + height) + " ";
}
std::string polyline(const std::vector<std::array<double, 2>>& points, const std::string& flags) {
    std::string text = "0 LWPOLYLINE 8 0 90 " + std::to_string(points.size()) + " 70 " + flags;
    for (const auto& [x, y] : points) text += " 10 " + number(x) + " 20 " + number(y);
    return text + " ";
}
std::string closed(const std::vector<std::array<double, 2>>& points) {
    return polyline(points, "1");
}
std::string open(const std::vector<std::array<double, 2>>& points) {
    return polyline(points, "0");
}
std::string square_of_lines(double side) {
    return line(0, 0, side, 0) + line(side, 0, side, side) + line(side, side, 0, side) + line(0, side, 0, 0);
}
using Point3 = std::array<double, 3>;
/// The groups of a point in space; `code` is the code of x.
std::string in_space(const Point3& point, int code = 10) {
    return " " + std::to_string(code) + " " + number(point[0]) + " " + std::to_string(code + 10) + " " +
           number(point[1]) + " " + std::to_string(code + 20) + " " + number(point[2]);
}
/// The corners of a square of 100 mm in the plane, at z plus the slope times (x + y).
std::vector<Point3> corners(double z, double slope) {
    return {{0, 0, z}, {100, 0, z + 100 * slope}, {100, 100, z + 200 * slope}, {0, 100, z + 100 * slope}};
}
std::string lines_in_space(const std::vector<Point3>& points) {
    std::string text;
    for (std::size_t i = 0; i < points.size(); ++i)
        text += "0 LINE 8 0" + in_space(points[i]) + in_space(points[(i + 1) % points.size()], 11) + " ";
    return text;
}
std::string polyline_in_space(const std::vector<Point3>& points) {
    std::string text = "0 POLYLINE 8 0 66 1 70 9";
    for (const Point3& point : points) text += " 0 VERTEX 8 0 70 32" + in_space(point);
    return text + " 0 SEQEND ";
}
/// A spline of degree 1 around four points.
std::string spline_in_space(const std::vector<Point3>& points) {
    std::string text = "0 SPLINE 8 0 70 0 71 1 40 0 40 0 40 1 40 2 40 3 40 4 40 4";
    for (const Point3& point : points) text += in_space(point);
    return text + in_space(points.front()) + " ";
}
constexpr double kRound = 0.1;  // square millimetres: 0.02 mm times a few millimetres of curves

TEST(DxfDrawing, AnEllipseLiesAlongItsMajorAxis) {
    const OutlineFile file = read("0 ELLIPSE 10 5 20 5 11 0 21 4 40 0.5 41 0 42 6.283185307179586");
    EXPECT_NEAR(area(file), 8 * kPi, kRound);
    EXPECT_EQ(size_text(file.parts), "4 x 8 mm");
    const OutlineFile half =
        read("0 ELLIPSE 10 0 20 0 11 4 21 0 40 0.5 41 0 42 3.141592653589793 " + line(-4, 0, 4, 0));
    EXPECT_NEAR(area(half), 4 * kPi, kRound);
    EXPECT_GT(half.parts.front().boundary.size(), 8U);
}

TEST(DxfDrawing, ASplineIsTheCurveOfItsKnotsAndWeights) {
    // Four rational quadratic arcs are a circle of radius 10 (Piegl and Tiller, The NURBS Book, Section 7.5).
    const std::string w = number(std::sqrt(0.5));
    std::string circle = "0 SPLINE 70 12 71 2 72 12 73 9";
    for (const char* knot : {"0", "0", "0", "1", "1", "2", "2", "3", "3", "4", "4", "4"})
        circle += " 40 " + std::string(knot);
    for (int i = 0; i < 9; ++i) circle += " 41 " + (i % 2 == 0 ? std::string("1") : w);
    for (const char* point : {"10 20 0", "10 20 10", "0 20 10", "-10 20 10", "-10 20 0", "-10 20 -10",
                              "0 20 -10", "10 20 -10", "10 20 0"})
        circle += " 10 " + std::string(point);
    EXPECT_NEAR(area(read(circle)), 100 * kPi, 1);
    EXPECT_THAT(complaint_of([] { read("0 SPLINE 70 0 71 3 40 0 40 1 10 0 20 0 10 1 20 1"); }),
                HasSubstr("2 control points and 2 knots"));
}

TEST(DxfDrawing, ASplineOfEqualKnotsIsLeftOut) {
    const OutlineFile file =
        read(rectangle(0, 0, 10, 10) + "0 SPLINE 8 0 70 8 71 1 40 0 40 0 40 0 40 0 10 2 20 2 10 4 20 4");
    EXPECT_NEAR(area(file), 100, 1e-6);
    EXPECT_THAT(file.remarks, ElementsAre("1 SPLINE of equal knots left out"));
}

TEST(DxfDrawing, ABlockIsDrawnWhereItIsInserted) {
    const std::string block = "0 BLOCK 8 0 2 Plate 10 5 20 5 " + rectangle(5, 5, 10, 20) + " 0 ENDBLK ";
    EXPECT_NEAR(area(read(Sections{"0 INSERT 2 PLATE 10 100 20 0", "", block})), 200, 1e-6);
    EXPECT_NEAR(area(read(Sections{"0 INSERT 2 plate 10 100 20 0 41 2 42 -3 50 30", "", block})), 1200, 1e-6);
    const OutlineFile array =
        read(Sections{"0 INSERT 2 plate 10 0 20 0 70 3 71 2 44 15 45 25 50 90", "", block});
    EXPECT_EQ(array.parts.size(), 6U);
    EXPECT_EQ(size_text(array.parts), "45 x 40 mm");  // turned by 90 degrees
    const OutlineFile mirrored = read(Sections{"0 INSERT 2 plate 10 100 20 0 230 -1", "", block});
    EXPECT_NEAR(mirrored.parts.front().boundary.front().x, -0.1, 1e-12);
}

TEST(DxfDrawing, BlocksInBlocksEndSomewhere) {
    const std::string self = "0 BLOCK 2 A 0 INSERT 2 A 0 ENDBLK ";
    EXPECT_THAT(complaint_of([&] {
                    read(Sections{"0 INSERT 2 A", "", self});
                }),
                HasSubstr("contains itself"));
    std::string bomb = "0 BLOCK 2 B0 0 TEXT 1 a 0 ENDBLK ";
    for (int i = 1; i < 30; ++i) {
        const std::string before = " 0 INSERT 2 B" + std::to_string(i - 1);
        bomb += " 0 BLOCK 2 B" + std::to_string(i) + before + before + " 0 ENDBLK ";
    }
    EXPECT_THAT(complaint_of([&] {
                    read(Sections{"0 INSERT 2 B29", "", bomb});
                }),
                HasSubstr("more than 200000 entities"));
    EXPECT_THAT(complaint_of([&] {
                    read(Sections{"0 INSERT 2 B0 70 100000 71 100000", "", bomb});
                }),
                HasSubstr("copies"));
    EXPECT_THAT(read(Sections{rectangle(0, 0, 9, 9) + "0 INSERT 2 none", "", ""}).remarks,
                ElementsAre("1 INSERT of a block that is not there left out"));
}

TEST(DxfDrawing, LayersThatAreOffAndPaperSpaceDoNotCount) {
    const std::string layers = "0 LAYER 2 Off 70 0 62 -7 0 LAYER 2 Frozen 70 1 62 7 0 LAYER 2 On 70 0 62 7 ";
    const OutlineFile file = read(Sections{
        rectangle(0, 0, 10, 10, "on") + rectangle(50, 0, 20, 20, "OFF") + rectangle(50, 0, 30, 30, "Frozen") +
            "0 CIRCLE 67 1 10 0 20 0 40 100 0 CIRCLE 60 1 10 0 20 0 40 100",
        layers, ""});
    EXPECT_NEAR(area(file), 100, 1e-6);
    EXPECT_THAT(file.remarks,
                ElementsAre("2 on layers that are off, 1 in paper space, 1 invisible left out"));
}

TEST(DxfDrawing, InABlockLayerZeroIsTheLayerOfTheInsertion) {
    const std::string layers = "0 LAYER 2 Off 70 0 62 -7 0 LAYER 2 Frozen 70 1 62 7 ";
    const std::string block =
        "0 BLOCK 2 A " + rectangle(0, 0, 10, 10, "0") + rectangle(50, 0, 20, 20, "Own") + " 0 ENDBLK ";
    EXPECT_NEAR(area(read(Sections{"0 INSERT 2 A 8 Any", layers, block})), 500, 1e-6);
    EXPECT_NEAR(area(read(Sections{"0 INSERT 2 A 8 Off", layers, block})), 400, 1e-6);
    EXPECT_THAT(complaint_of([&] {
                    read(Sections{"0 INSERT 2 A 8 Frozen", layers, block});
                }),
                HasSubstr("1 on layers that are off left out"));
}

TEST(DxfDrawing, LayerZeroIsInheritedThroughBlocksInBlocks) {
    const std::string layers = "0 LAYER 2 0 70 0 62 -7 0 LAYER 2 Off 70 0 62 -7 0 LAYER 2 Frozen 70 1 62 7 ";
    const std::string blocks =
        "0 BLOCK 2 A " + rectangle(0, 0, 10, 10, "0") + rectangle(50, 0, 20, 20, "Own") +
        "0 ENDBLK 0 BLOCK 2 INHERITS 0 INSERT 2 A 8 0 0 ENDBLK 0 BLOCK 2 OWN 0 INSERT 2 A 8 Own 0 ENDBLK "
        "0 BLOCK 2 HIDES 0 INSERT 2 A 8 Frozen 0 ENDBLK ";
    const auto drawn = [&](const std::string& block, const std::string& layer) {
        return area(read(Sections{rectangle(100, 0, 1, 1, "Own") + "0 INSERT 2 " + block + layer, layers,
                                  blocks})) -
               1;
    };
    EXPECT_NEAR(drawn("INHERITS", " 8 Any"), 500, 1e-6);
    EXPECT_NEAR(drawn("INHERITS", " 8 Off"), 400, 1e-6);
    EXPECT_NEAR(drawn("INHERITS", " 8 Frozen"), 0, 1e-6);
    EXPECT_NEAR(drawn("INHERITS", ""), 400, 1e-6) << "the drawing's own layer 0 is off";
    EXPECT_NEAR(drawn("OWN", " 8 Off"), 500, 1e-6);
    EXPECT_NEAR(drawn("HIDES", " 8 Any"), 0, 1e-6);
}

TEST(DxfDrawing, EntitiesSeenFromBelowAreMirrored) {
    const OutlineFile file = read("0 CIRCLE 10 100 20 50 40 10 210 0 220 0 230 -1");
    double x = 0;
    for (const auto& point : file.parts.front().boundary)
        x += point.x / static_cast<double>(file.parts.front().boundary.size());
    EXPECT_NEAR(x, -0.1, 1e-6);
    EXPECT_THAT(complaint_of([] { read("0 CIRCLE 10 0 20 0 40 1 210 1 220 0 230 0"); }),
                HasSubstr("1 CIRCLE that does not lie flat"));
}

TEST(DxfDrawing, CurvesTiltedInSpaceAreLeftOut) {
    const std::vector<Point3> tilted = corners(0, 0.5);
    const std::string flat = rectangle(200, 0, 10, 10);
    const auto expect_left_out = [&](const std::string& entities, const std::string& remark) {
        const OutlineFile file = read(flat + entities);
        EXPECT_NEAR(area(file), 100, 1e-6) << remark;
        EXPECT_THAT(file.remarks, ElementsAre(remark));
    };
    expect_left_out(lines_in_space(tilted), "4 LINE that does not lie flat left out");
    expect_left_out(polyline_in_space(tilted), "1 POLYLINE that does not lie flat left out");
    expect_left_out(spline_in_space(tilted), "1 SPLINE that does not lie flat left out");
    expect_left_out(polyline_in_space({{0, 0, 0}, {10, 0, 0}, {10, 10, 5}, {0, 10, 0}}),
                    "1 POLYLINE that does not lie flat left out");  // in no plane
    expect_left_out("0 LINE 10 5 20 5 30 0 11 5 21 5 31 10", "1 LINE that does not lie flat left out");
    const std::string ellipse = "0 ELLIPSE 10 100 20 0 30 5 11 40 21 0 31 ";
    expect_left_out(ellipse + "30 40 0.5", "1 ELLIPSE that does not lie flat left out");
    expect_left_out(ellipse + "-30 40 0.5 41 0 42 1 210 0 220 0 230 1",
                    "1 ELLIPSE that does not lie flat left out");
}

TEST(DxfDrawing, ASlopeOfAThousandthIsNotFlat) {
    EXPECT_THAT(complaint_of([] { read(polyline_in_space(corners(0, 0.001))); }),
                HasSubstr("1 POLYLINE that does not lie flat left out"));
}

TEST(DxfDrawing, ASquareOfLinesThatIsTiltedAboutASideIsRefusedWithTheReason) {
    const double half = 100 * std::sqrt(0.5);
    EXPECT_THAT(complaint_of([&] {
                    read(lines_in_space({{0, 0, 0}, {100, 0, 0}, {100, half, half}, {0, half, half}}));
                }),
                AllOf(HasSubstr("not closed"), HasSubstr("2 LINE that does not lie flat left out")));
}

TEST(DxfDrawing, CurvesAtAnyConstantHeightAreTaken) {
    for (const double slope : {0.0, 1e-8})  // 1e-8: the last digit of z
        for (const std::string& square :
             {lines_in_space(corners(5, slope)), polyline_in_space(corners(5, slope)),
              spline_in_space(corners(5, slope))}) {
            const OutlineFile file = read(square);
            EXPECT_NEAR(area(file), 1e4, kRound) << square;
            EXPECT_THAT(file.remarks, IsEmpty()) << square;
        }
    // A line of half a millimetre whose z is rounded to a thousandth.
    const OutlineFile rounded = read(
        lines_in_space({{0, 0, 5}, {100, 0, 5}, {100, 100, 5}, {0.5, 100, 5}, {0, 100, 5.001}, {0, 50, 5}}));
    EXPECT_NEAR(area(rounded), 1e4, kRound);
    EXPECT_THAT(rounded.remarks, IsEmpty());
    const OutlineFile ellipse = read("0 ELLIPSE 10 0 20 0 30 5 11 4 21 0 31 1e-9 40 0.5");
    EXPECT_NEAR(area(ellipse), 8 * kPi, kRound);
    EXPECT_THAT(ellipse.remarks, IsEmpty());
}

TEST(DxfDrawing, CurvesInABlockLieFlatOrNotByTheirOwnHeights) {
    const auto block = [](const std::string& entities) { return "0 BLOCK 2 A " + entities + "0 ENDBLK "; };
    const OutlineFile flat =
        read(Sections{"0 INSERT 2 A 10 0 20 0 30 7 41 2 42 2", "", block(polyline_in_space(corners(5, 0)))});
    EXPECT_NEAR(area(flat), 4e4, kRound);
    EXPECT_THAT(flat.remarks, IsEmpty());
    const OutlineFile tilted =
        read(Sections{rectangle(200, 0, 10, 10) + "0 INSERT 2 A 10 0 20 0 41 2 42 2 230 -1", "",
                      block(spline_in_space(corners(5, 0.5)))});
    EXPECT_NEAR(area(tilted), 100, 1e-6);
    EXPECT_THAT(tilted.remarks, ElementsAre("1 SPLINE that does not lie flat left out"));
}

TEST(DxfDrawing, OtherEntitiesAreCountedAndTold) {
    const OutlineFile file = read("0 TEXT 1 a 0 TEXT 1 b 0 HATCH 0 MTEXT 1 c 0 TEXT 1 d 0 POINT 10 1 20 1 " +
                                  rectangle(0, 0, 10, 10));
    EXPECT_NEAR(area(file), 100, 1e-6);
    EXPECT_THAT(file.remarks, ElementsAre("3 TEXT, 1 HATCH, 1 MTEXT left out"));
}

TEST(DxfDrawing, EndsThatNearlyMeetAreJoinedAndTold) {
    const OutlineFile file =
        read(line(0, 0, 100, 0) + line(100.02, 0, 100, 100) + line(100, 100, 0, 100) + line(0, 99.97, 0, 0));
    EXPECT_NEAR(area(file), 10000, 10);
    EXPECT_THAT(file.remarks, ElementsAre("2 gaps of at most 0.03 mm closed"));
    EXPECT_THAT(
        complaint_of([] { read(line(0, 0, 100, 0) + line(100, 0, 100, 100) + line(100, 100, 0, 0.3)); }),
        AllOf(HasSubstr("not closed"), HasSubstr("from (0, 0) mm to (100, 0) mm"),
              HasSubstr("up to 0.1 mm")));
}

TEST(DxfDrawing, DoubledLinesAreOne) {
    const OutlineFile file = read(square_of_lines(50) + line(50, 50, 50, 0) + rectangle(10, 10, 5, 5) +
                                  rectangle(10, 10, 5, 5) + line(0, 0, 50, 0));
    EXPECT_NEAR(area(file), 2500 - 25, 1e-6);
    EXPECT_THAT(file.remarks, ElementsAre("3 doubled lines taken once"));
}

TEST(DxfDrawing, CurvesWithTheSameBoxAndAreaMayDiffer) {
    const OutlineFile halves =
        read(closed({{0, 0}, {10, 0}, {10, 10}}) + closed({{0, 0}, {10, 10}, {0, 10}}));
    EXPECT_NEAR(area(halves), 100, 1e-6);
    EXPECT_THAT(halves.remarks, IsEmpty());
    // Bars of 100 mm by 10 mm around the origin.
    const auto bar = [](double angle) {
        const auto corner = [&](double along, double across) {
            return std::array{along * std::cos(angle) - across * std::sin(angle),
                              along * std::sin(angle) + across * std::cos(angle)};
        };
        return closed({corner(-50, -5), corner(50, -5), corner(50, 5), corner(-50, 5)});
    };
    const double shared = 10 * 10 / std::sin(kPi / 3);  // the rhombus where they cross
    EXPECT_NEAR(area(read(bar(kPi / 6) + bar(-kPi / 6))), 2 * 1000 - shared, 0.01);
}

TEST(DxfDrawing, ALineAndItsMirrorImageDiffer) {
    // Two squares that stand on their corners.
    const OutlineFile file =
        read(open({{0, 0}, {10, 10}, {30, -10}, {40, 0}}) + open({{0, 0}, {10, -10}, {30, 10}, {40, 0}}));
    EXPECT_NEAR(area(file), 2 * 200, 0.1);
    EXPECT_THAT(file.remarks, Each(Not(HasSubstr("doubled"))));
}

TEST(DxfDrawing, LooseLinesAreLeftOutAndRoomsAreOneShape) {
    const OutlineFile file =
        read(square_of_lines(50) + line(25, 0, 25, 50) + line(50, 50, 60, 60) + line(10, 10, 12, 10));
    EXPECT_NEAR(area(file), 2500, 1e-6);
    EXPECT_THAT(file.remarks, ElementsAre(AllOf(HasSubstr("2 open lines"), HasSubstr("14.14 mm"))));
}

TEST(DxfDrawing, AClosedGapIsNoOpenLine) {
    const OutlineFile file = read(square_of_lines(50) + line(100, 0, 110, 0) + line(110.01, 0, 120, 0));
    EXPECT_THAT(file.remarks, Contains(HasSubstr("1 gap")));
    EXPECT_THAT(file.remarks, Contains(HasSubstr("2 open lines")));
}

TEST(DxfDrawing, AnEndThatLiesOnALineButForRoundingIsJoinedToIt) {
    // A bay whose sides end 1 um before, and 1 um behind, the long line.
    const OutlineFile file = read(line(-50, 0, 50, 0) + line(-10, 0.001, -10, 20) + line(-10, 20, 10, 20) +
                                  line(10, 20, 10, -0.001));
    EXPECT_NEAR(area(file), 400, 0.2);
}

TEST(DxfDrawing, LinesThatCrossAtTheCornersEncloseWhatIsBetween) {
    EXPECT_NEAR(
        area(read(line(-5, 0, 55, 0) + line(50, -5, 50, 55) + line(55, 50, -5, 50) + line(0, 55, 0, -5))),
        2500, 1e-6);
}

TEST(DxfDrawing, HolesIslandsAndUnions) {
    const OutlineFile nested =
        read(rectangle(0, 0, 90, 90) + rectangle(10, 10, 70, 70) + rectangle(20, 20, 50, 50));
    ASSERT_EQ(nested.parts.size(), 2U);
    EXPECT_NEAR(area(nested), 8100 - 4900 + 2500, 1e-6);
    EXPECT_EQ(nested.parts.front().holes.size(), 1U);
    EXPECT_NEAR(area(read(rectangle(0, 0, 20, 20) + rectangle(10, 10, 20, 20))), 700, 1e-6);
    EXPECT_NEAR(area(read(rectangle(0, 0, 20, 20) + rectangle(0, 5, 5, 5))), 375,
                1e-6);  // a notch from the rim
    EXPECT_THAT(read(rectangle(0, 0, 90, 90)).remarks, IsEmpty());
}

// More than 256 curves in one another are refused; equal ones do not lie in one another, wherever they begin.
TEST(DxfDrawing, HundredsOfEqualCurvesAreOneAndToldOf) {
    const std::string begun_elsewhere =
        "0 LWPOLYLINE 8 0 90 4 70 1 10 50 20 0 10 50 20 40 10 0 20 40 10 0 20 0 ";
    std::string many = rectangle(-10, -10, 80, 70);
    for (int i = 0; i < 300; ++i) many += rectangle(0, 0, 50, 40) + begun_elsewhere;
    const OutlineFile file = read(many);
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_EQ(file.parts.front().holes.size(), 1U);
    EXPECT_THAT(file.remarks, testing::Contains(HasSubstr("599 doubled lines taken once")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
