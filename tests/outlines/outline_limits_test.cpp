// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings that would take minutes or gigabytes are refused, or read fast all the same.
#include "outlines/outlines.hpp"

#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/dxf/dxf_curves.hpp>
#include <fretwork/outlines/outline.hpp>
#include <fretwork/outlines/outline_check.hpp>
#include <fretwork/outlines/regions/filled_region.hpp>
#include <fretwork/outlines/regions/welding.hpp>

namespace fretwork::outlines {
namespace THIS_TEST {

using geometry::Polygon;
using test::complaint_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

/// Codes and values, one after the other, become a DXF file in millimetres.
std::string dxf(const std::string& entities, const std::string& blocks = "") {
    std::string text =
        "0 SECTION 2 BLOCKS " + blocks + "0 ENDSEC 0 SECTION 2 ENTITIES " + entities + "0 ENDSEC 0 EOF ";
    std::ranges::replace(text, ' ', '\n');
    return text;
}
std::string refuse(const std::string& entities, const std::string& blocks = "") {
    return refuse_file("o.dxf", dxf(entities, blocks));
}
std::string place(double x, double y) {
    return "10 " + std::to_string(x) + " 20 " + std::to_string(y) + " ";
}

TEST(OutlineLimits, CopiesOfEmptyBlocksCount) {
    EXPECT_THAT(refuse("0 INSERT 2 B 70 199998 ",
                       "0 BLOCK 2 A 0 ENDBLK 0 BLOCK 2 B 0 INSERT 2 A 70 200000 "
                       "0 ENDBLK "),
                AllOf(HasSubstr("o.dxf: line"), HasSubstr("more than 200000 copies of blocks")));
}

TEST(OutlineLimits, CopiesOfALongEntityCount) {
    std::string text = "0 BLOCK 2 A 0 TEXT ";
    for (int i = 0; i < 4000; ++i) text += "1 " + std::string(250, 'a') + " ";
    EXPECT_THAT(refuse("0 INSERT 2 A 70 2000 ", text + "0 ENDBLK "),
                AllOf(HasSubstr("o.dxf: line"), HasSubstr("more than 1000000000 characters")));
}

// Programs hide data of their own in entities: reactors, dictionaries, pictures, extended data.
TEST(OutlineLimits, DataOfOtherProgramsArePassedOver) {
    const std::string megabyte(1'000'000, '1');
    const std::string text = "0 TEXT 102 {ACAD_XDICTIONARY 360 1F 102 } 310 " + megabyte +
                             " 1 a 1001 OTHER 1000 " + megabyte + " ";
    const std::string square =
        "0 LWPOLYLINE 102 {ACAD_REACTORS 330 1F 102 } 8 0 90 4 70 1 10 0 20 0 10 9 20 0 10 9 20 9 10 0 20 9 "
        "1001 OTHER 1008 Off 1010 1e9 1020 1e9 1030 1e9 1042 1 1060 1 1067 1 1070 0 ";
    const TemporaryFolder folder;
    const OutlineFile file = read_outline_file(
        folder.file("o.dxf", dxf(square + "0 INSERT 2 A 70 2000 ", "0 BLOCK 2 A " + text + "0 ENDBLK ")));
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_NEAR(1e6 * area_of(file.parts.front()), 81, 1e-6);
    EXPECT_THAT(file.remarks, testing::Contains("2000 TEXT left out"));
}

TEST(OutlineLimits, APolylineWithOnePointTooManyIsRefused) {
    std::string polyline = "0 LWPOLYLINE 90 200001 70 1 ";
    for (int i = 0; i < 200'001; ++i)
        polyline += "10 " + std::to_string(i) + " 20 " + std::to_string(i % 2) + " ";
    EXPECT_THAT(refuse(polyline), HasSubstr("more than 200000 points"));
}

/// The number of points that are made of an entity in kilometres, of which 1000 are allowed.
std::size_t points_made(const std::string& entity) {
    constexpr double kKilometre = 1000.0;
    const detail::DxfFile file("o.dxf", dxf(entity));
    const detail::DxfFlattening how{{{kKilometre, 0, 0, kKilometre, 0, 0}, detail::kFlatteningTolerance},
                                    1000};
    return draw_dxf_entity(file, file.entities(), how).curve.value().points.size();
}

TEST(OutlineLimits, ACurveOfFarTooManyPointsEndsEarly) {
    constexpr int kPlaces = 40;
    std::string spline = "0 SPLINE 71 3 ";
    std::string arcs = "0 LWPOLYLINE 90 " + std::to_string(kPlaces) + " 70 0 ";
    for (int i = 0; i < kPlaces + 4; ++i) spline += "40 " + std::to_string(i) + " ";
    for (int i = 0; i < kPlaces; ++i) {
        spline += place(i, 9 * (i % 2));
        arcs += place(i, 9 * (i % 2)) + "42 0.5 ";
    }
    EXPECT_EQ(points_made(spline), 1001U);
    EXPECT_GT(points_made(arcs), 1000U);
    EXPECT_LT(points_made(arcs), 50'000U) << "one arc has thousands, and all of them 39 times as many";
}

TEST(OutlineLimits, TheToleranceOfTheSmallestDrawingIsAboveZero) {
    EXPECT_GT(detail::flattening_tolerance(1e-320), 0.0);
}

TEST(OutlineLimits, FarTooManyPairsOfLooseEndsAreRefused) {
    EXPECT_THAT(
        refuse("0 POINT 10 200 20 0 0 INSERT 2 A 10 0 20 0 70 100 71 200 44 0.012 45 0.006 ",
               "0 BLOCK 2 A 0 LINE 10 0 20 0 11 0.006 21 0 0 ENDBLK "),
        AllOf(HasSubstr("o.dxf: "), HasSubstr("more than 20000000 pairs of loose ends lie within 0.2 mm")));
}

TEST(OutlineLimits, FarTooManyNearSidesAreRefused) {
    constexpr int kPoints = 7000;
    Polygon zigzag;
    for (int i = 0; i < kPoints; ++i) {
        const double y = 9.0 * i / kPoints;
        zigzag.push_back(i % 2 == 0 ? geometry::Point2{0, y} : geometry::Point2{9, 9 - y});
    }
    EXPECT_THAT(complaint_of([&] { make_outline(zigzag, {}); }),
                AllOf(HasSubstr("near each other more than 20000000 times"), HasSubstr("of the boundary")));
}

// All teeth of a saw are one, because each is nearer to the next than the width.
TEST(OutlineLimits, WeldingMergesALongRowOfCorners) {
    constexpr double kStep = 2.2e-6;
    constexpr double kWidth = 5e-6;
    constexpr int kSteps = 50'000;
    Polygon saw;
    for (int i = 0; i <= kSteps; ++i) saw.push_back({kStep * i, i % 2 == 0 ? 0 : 1e-3});
    saw.push_back({kStep * kSteps, -0.1});
    saw.push_back({0, -0.1});
    EXPECT_EQ(detail::weld({&saw}, kWidth), kSteps - 1);
    EXPECT_EQ(saw, (Polygon{{0, 0}, {kStep * kSteps, -0.1}, {0, -0.1}}));
}

/// A square around the origin.
Polygon square(double half) {
    return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

TEST(OutlineLimits, ManyCurvesLieInManyCurves) {
    constexpr int kSquares = 255;
    constexpr int kRows = 40;
    std::vector<Polygon> curves;
    for (int i = 0; i < kSquares; ++i) curves.push_back(square(1 + 0.01 * i));
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kRows; ++column) {
            const double x = 0.04 * column - 0.8;
            const double y = 0.04 * row - 0.8;
            curves.push_back({{x, y}, {x + 0.02, y}, {x, y + 0.02}});
        }
    }
    const detail::Region region = detail::nested_region(curves, detail::kFlatteningTolerance);
    ASSERT_EQ(region.parts.size(), 128U);  // the innermost square, the largest, and rings around it
    EXPECT_EQ(region.parts.front().holes.size(), std::size_t{kRows} * kRows);
    for (std::size_t ring = 1; ring < region.parts.size(); ++ring)
        ASSERT_EQ(region.parts[ring].holes.size(), 1U) << "ring " << ring;
}

// Beside one another, and in one another at different depths.
TEST(OutlineLimits, CurvesAreNestedAsTheyLie) {
    const auto moved = [](Polygon polygon, double x) {
        for (geometry::Point2& point : polygon) point.x += x;
        return polygon;
    };
    std::vector<Polygon> curves{square(20)};
    for (const double x : {-10.0, 0.0, 10.0})
        for (const double half : {4.0, 3.0, 2.0}) curves.push_back(moved(square(half), x));
    curves.push_back(moved(square(1), 10));
    const detail::Region region = detail::nested_region(curves, detail::kFlatteningTolerance);
    double area = 0;
    for (const Outline& part : region.parts) area += area_of(part);
    EXPECT_NEAR(area, 1600 - 3 * 64 + 3 * (36 - 16) + 4, 1e-9);
    EXPECT_EQ(region.parts.size(), 5U);
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines
