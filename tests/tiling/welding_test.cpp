// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that nearly meet, as drawings leave them: no tile fits into the slit or the needle between them.
#include "outlines.hpp"

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/detail/welding.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::tiling {
namespace {

using pattern::Polygon;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kTile = 0.026;  // metres

/// A drawing of 500 mm: curves are flattened to 0.02 mm, and slits up to a quarter of it closed.
OutlineFile read(const std::string& path) {
    const test::TemporaryFolder folder;
    const std::string svg =
        "<svg xmlns='http://www.w3.org/2000/svg' width='500mm' height='500mm' "
        "viewBox='0 0 500 500'><path fill-rule='evenodd' d='" +
        path + "'/></svg>";
    return read_outline_file(folder.file("drawing.svg", svg));
}

double square_millimetres(const OutlineFile& file) {
    return 1e6 * area_of(file.parts.front());
}

void expect_tiled(const OutlineFile& file) {
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_NO_THROW(
        tessellate(file.parts.front(), pattern::find_node_layout("paper7"), {.edge_length = kTile}));
}

TEST(Weld, LeavesLoopsAloneWhoseCornersAreFarApart) {
    Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Polygon before = square;
    EXPECT_EQ(detail::weld({&square}, 1e-3), 0);
    EXPECT_EQ(square, before);
}

TEST(Weld, ClosesASlit) {
    for (const std::string width : {"0.0000001", "0.0001", "0.004"}) {
        const OutlineFile file = read("M0 0H500V250H250v" + width + "H500V500H0Z");
        EXPECT_NEAR(square_millimetres(file), 250'000, 1e-3) << width;
        EXPECT_EQ(file.parts.front().boundary.size(), 5U) << width;
        EXPECT_THAT(file.remarks, Contains(HasSubstr("slits and needles narrower than 0.005 mm")));
        expect_tiled(file);
    }
}

TEST(Weld, LeavesASlitThatACutterCouldMake) {
    const OutlineFile file = read("M0 0H500V250H250v0.1H500V500H0Z");
    EXPECT_NEAR(square_millimetres(file), 250'000 - 25, 1e-3);
    EXPECT_THAT(file.remarks, IsEmpty());
}

TEST(Weld, CutsOffANeedle) {
    const OutlineFile file = read("M0 0H300V100L499 100.001L300 100.002V400H0Z");
    EXPECT_NEAR(square_millimetres(file), 120'000, 1e-2);
    expect_tiled(file);
}

TEST(Weld, BluntsASlitThatEndsSharply) {
    const OutlineFile file = read("M0 0H500V250L250 250.1L500 250.2V500H0Z");
    EXPECT_NEAR(square_millimetres(file), 250'000 - 25, 0.2);
    expect_tiled(file);
}

TEST(Weld, OpensAHoleThatNearlyTouchesTheRim) {
    for (const std::string gap : {"0.00000003", "0.0001", "0.003"}) {
        const OutlineFile file = read("M0 0H500V500H0Z M" + gap + " 250L150 150V350Z");
        EXPECT_THAT(file.parts.front().holes, IsEmpty()) << gap;
        EXPECT_NEAR(square_millimetres(file), 250'000 - 15'000, 20) << gap;
        expect_tiled(file);
    }
}

TEST(Weld, OpensCornersOfTwoHolesThatNearlyTouch) {
    const OutlineFile file = read(
        "M0 0H500V500H0Z M100 250L250 150V249.9999999L250 350Z "
        "M400 250L250.0000001 250L350 350Z");
    expect_tiled(file);
}

TEST(ScaledToWidth, LeavesNoSideWithoutLength) {
    const double next = std::nextafter(0.1, 1.0);
    const OutlineFile file{{make_outline({{0, 0}, {0.1, 0}, {next, 0.0}, {0.2, 0.1}, {0, 0.1}}, {})}, {}};
    const OutlineFile scaled = scaled_to_width(file, 0.05);
    EXPECT_NO_THROW(make_outline(scaled.parts.front().boundary, {}));
}

}  // namespace
}  // namespace fretwork::tiling
