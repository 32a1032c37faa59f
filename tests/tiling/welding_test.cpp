// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that nearly meet, as drawings leave them: no tile fits into the slit or the needle between them.
#include "outlines/outlines.hpp"

#include <fretwork/outlines/regions/welding.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::tiling {
namespace THIS_TEST {

using geometry::Polygon;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kTile = 0.026;  // metres

/// A drawing of 500 mm: curves are flattened to 0.02 mm, and slits up to a quarter of it closed.
outlines::OutlineFile read(const std::string& path) {
    const test::TemporaryFolder folder;
    const std::string svg =
        "<svg xmlns='http://www.w3.org/2000/svg' width='500mm' height='500mm' "
        "viewBox='0 0 500 500'><path fill-rule='evenodd' d='" +
        path + "'/></svg>";
    return outlines::read_outline_file(folder.file("drawing.svg", svg));
}

double square_millimetres(const outlines::OutlineFile& file) {
    return 1e6 * area_of(file.parts.front());
}

void expect_tiled(const outlines::OutlineFile& file) {
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_NO_THROW(
        tessellate(file.parts.front(), pattern::find_node_layout("paper7"), {.edge_length = kTile}));
}

TEST(Weld, LeavesLoopsAloneWhoseCornersAreFarApart) {
    Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Polygon before = square;
    EXPECT_EQ(outlines::detail::weld({&square}, 1e-3), 0);
    EXPECT_EQ(square, before);
}

TEST(Weld, ClosesASlit) {
    for (const std::string width : {"0.0000001", "0.0001", "0.004"}) {
        const outlines::OutlineFile file = read("M0 0H500V250H250v" + width + "H500V500H0Z");
        EXPECT_NEAR(square_millimetres(file), 250'000, 1e-3) << width;
        EXPECT_EQ(file.parts.front().boundary.size(), 5U) << width;
        EXPECT_THAT(file.remarks, Contains(HasSubstr("slits and needles narrower than 0.005 mm")));
        expect_tiled(file);
    }
}

TEST(Weld, LeavesASlitThatACutterCouldMake) {
    const outlines::OutlineFile file = read("M0 0H500V250H250v0.1H500V500H0Z");
    EXPECT_NEAR(square_millimetres(file), 250'000 - 25, 1e-3);
    EXPECT_THAT(file.remarks, IsEmpty());
}

TEST(Weld, CutsOffANeedle) {
    const outlines::OutlineFile file = read("M0 0H300V100L499 100.001L300 100.002V400H0Z");
    EXPECT_NEAR(square_millimetres(file), 120'000, 1e-2);
    expect_tiled(file);
}

TEST(Weld, BluntsASlitThatEndsSharply) {
    const outlines::OutlineFile file = read("M0 0H500V250L250 250.1L500 250.2V500H0Z");
    EXPECT_NEAR(square_millimetres(file), 250'000 - 25, 0.2);
    expect_tiled(file);
}

TEST(Weld, OpensAHoleThatNearlyTouchesTheRim) {
    for (const std::string gap : {"0.00000003", "0.0001", "0.003"}) {
        const outlines::OutlineFile file = read("M0 0H500V500H0Z M" + gap + " 250L150 150V350Z");
        EXPECT_THAT(file.parts.front().holes, IsEmpty()) << gap;
        EXPECT_NEAR(square_millimetres(file), 250'000 - 15'000, 20) << gap;
        expect_tiled(file);
    }
}

TEST(Weld, OpensCornersOfTwoHolesThatNearlyTouch) {
    const outlines::OutlineFile file = read(
        "M0 0H500V500H0Z M100 250L250 150V249.9999999L250 350Z "
        "M400 250L250.0000001 250L350 350Z");
    expect_tiled(file);
}

TEST(ScaledToWidth, LeavesNoSideWithoutLength) {
    const double next = std::nextafter(0.1, 1.0);
    const outlines::OutlineFile file{
        {outlines::make_outline({{0, 0}, {0.1, 0}, {next, 0.0}, {0.2, 0.1}, {0, 0.1}}, {})}, {}};
    const outlines::OutlineFile scaled = scaled_to_width(file, 0.05);
    EXPECT_NO_THROW(outlines::make_outline(scaled.parts.front().boundary, {}));
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
