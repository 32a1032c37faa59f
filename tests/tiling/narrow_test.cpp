// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines with parts narrower than a tile: they keep their shape, or are refused.
#include "outlines/outlines.hpp"

#include <fretwork/tiling/detail/narrow_parts.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>
#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <numbers>

namespace fretwork::tiling {
namespace THIS_TEST {

using geometry::Point2;
using geometry::Polygon;
using test::complaint_of;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kSide = 0.026;  // m, of the tiles

TessellationResult tile(const outlines::Outline& outline,
                        const TessellationOptions& options = {.edge_length = kSide}) {
    const auto layout = pattern::find_node_layout("paper7");
    TessellationResult result = tessellate(outline, layout, options);
    validate(result.tessellation, layout);
    return result;
}

Polygon circle(Point2 center, double radius) {
    Polygon polygon;
    for (int i = 0; i < 120; ++i) {
        const double angle = 2 * std::numbers::pi * i / 120;
        polygon.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
    }
    return polygon;
}

const Polygon kPlate = {{0, 0}, {0.4, 0}, {0.4, 0.3}, {0, 0.3}};

/// The law of all tilings that are given back, but for overlaps, which random outlines are tested for.
void expect_good(const TessellationResult& result, const outlines::Outline& outline) {
    EXPECT_EQ(rim_loops(result.tessellation).size(), 1 + outline.holes.size());
    EXPECT_GE(result.report.covered_share, 0.98);
    EXPECT_GE(result.report.smallest_angle, 25 * std::numbers::pi / 180);
}

class Rings : public testing::TestWithParam<double> {};

TEST_P(Rings, StayClosedWhenTheirHoleIsOffTheMiddle) {
    const outlines::Outline ring =
        outlines::make_outline(circle({0, 0}, 0.15), {circle({GetParam(), 0}, 0.118)});
    const TessellationResult result = tile(ring);
    expect_good(result, ring);
    EXPECT_GT(result.report.refined_share, 0.0);
}
INSTANTIATE_TEST_SUITE_P(Offsets, Rings, testing::Values(0.0, 0.004, 0.02));

/// A star with points of 34 degrees: too wide to be cut off as needles, too sharp for a tile in their ends.
Polygon sharp_star() {
    constexpr int kPoints = 5;
    constexpr double kRadius = 0.25;  // m
    const double half = 17 * std::numbers::pi / 180;
    const double inner = kRadius * std::sin(half) / std::sin(half + std::numbers::pi / kPoints);
    Polygon star;
    for (int i = 0; i < 2 * kPoints; ++i) {
        const double radius = i % 2 == 0 ? kRadius : inner;
        const double angle = std::numbers::pi * i / kPoints;
        star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return star;
}

TEST(Narrow, TheSharpPointsOfAStarAreTiledWithSidesAsLongAsTheBarsNeed) {
    const outlines::Outline star = outlines::make_outline(sharp_star(), {});
    TessellationOptions options{.edge_length = kSide};
    options.smallest_side = 0.002;
    const TessellationResult result = tile(star, options);
    expect_good(result, star);
    for (std::size_t t = 0; t < result.tessellation.tiles.size(); ++t) {
        const Polygon polygon = tile_polygon(result.tessellation, TileIndex(static_cast<int>(t)));
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point2 way = polygon[(i + 1) % polygon.size()];
            EXPECT_GE(std::hypot(way.x - polygon[i].x, way.y - polygon[i].y), options.smallest_side);
        }
    }
}

TEST(Narrow, ABandOfHalfATileIsTiledFromEndToEnd) {
    const outlines::Outline band = outlines::make_outline({{0, 0}, {0.5, 0}, {0.5, 0.02}, {0, 0.02}}, {});
    const TessellationResult result = tile(band);
    expect_good(result, band);
    EXPECT_NEAR(result.report.covered_share, 1.0, 1e-9);
}

TEST(Narrow, TwoPlatesStayJoinedByAStripBetweenThem) {
    const outlines::Outline dumbbell = outlines::make_outline({{0, 0},
                                                               {0.2, 0},
                                                               {0.2, 0.09},
                                                               {0.3, 0.09},
                                                               {0.3, 0},
                                                               {0.5, 0},
                                                               {0.5, 0.2},
                                                               {0.3, 0.2},
                                                               {0.3, 0.11},
                                                               {0.2, 0.11},
                                                               {0.2, 0.2},
                                                               {0, 0.2}},
                                                              {});
    const TessellationResult result = tile(dumbbell);
    expect_good(result, dumbbell);
    EXPECT_LT(result.report.refined_share, 0.9) << "the plates keep large tiles";
}

TEST(Narrow, AHoleThatIsSmallerThanATileStaysAHole) {
    const outlines::Outline outline = outlines::make_outline(kPlate, {circle({0.2, 0.15}, 0.006)});
    expect_good(tile(outline), outline);
}

TEST(Narrow, AStripThatNoTileFitsIntoIsRefusedWithItsPlace) {
    const outlines::Outline outline = outlines::make_outline({{0, 0},
                                                              {0.2, 0},
                                                              {0.2, 0.0995},
                                                              {0.3, 0.0995},
                                                              {0.3, 0},
                                                              {0.5, 0},
                                                              {0.5, 0.2},
                                                              {0.3, 0.2},
                                                              {0.3, 0.1005},
                                                              {0.2, 0.1005},
                                                              {0.2, 0.2},
                                                              {0, 0.2}},
                                                             {});
    EXPECT_THAT(complaint_of([&] { tile(outline, {.edge_length = kSide, .smallest_side = 0.002}); }),
                AllOf(HasSubstr("too narrow for tiles with sides of 0.026 m near (0.2"), HasSubstr(", 0.1")));
}

TEST(Narrow, ASharpTipIsCutOffAndTheRestIsCovered) {
    const outlines::Outline wedge = outlines::make_outline({{0, 0}, {0.5, -0.05}, {0.5, 0.05}}, {});
    const TessellationResult result = tile(wedge);
    expect_good(result, wedge);
    EXPECT_LT(result.report.covered_share, 1.0);
}

TEST(Narrow, MergedABandHasFewerTilesThanRefined) {
    const outlines::Outline band = outlines::make_outline({{0, 0}, {0.5, 0}, {0.5, 0.015}, {0, 0.015}}, {});
    const TessellationResult refined = tile(band);
    const TessellationResult merged = tile(band, {.edge_length = kSide, .narrow = Narrow::Merge});
    expect_good(merged, band);
    EXPECT_LT(merged.report.tiles, 0.7 * refined.report.tiles);
}

TEST(Narrow, RefusedABandIsNamedWithItsWidthAndASideThatWorks) {
    const outlines::Outline band = outlines::make_outline({{0, 0}, {0.5, 0}, {0.5, 0.02}, {0, 0.02}}, {});
    const std::string complaint =
        complaint_of([&] { tile(band, {.edge_length = kSide, .narrow = Narrow::Refuse}); });
    EXPECT_THAT(complaint, AllOf(HasSubstr("is 0.02 m wide near ("), HasSubstr("; sides of 0.011 m work")));
    EXPECT_NO_THROW(tile(band, {.edge_length = 0.011, .narrow = Narrow::Refuse}));
}

TEST(Narrow, RefusedNoTileIsMadeSmallerThanWanted) {
    const outlines::Outline disc = outlines::make_outline(circle({0, 0}, 0.035), {});
    const TessellationOptions refuse{.edge_length = kSide, .narrow = Narrow::Refuse};
    ASSERT_GT(tile(disc).report.refined_share, 0.0);
    EXPECT_THAT(complaint_of([&] { tile(disc, refuse); }), HasSubstr("too narrow"));
}

TEST(Narrow, AStarSmallerThanATileIsToldASideThatWorks) {
    Polygon star;
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 0.008 : 0.003;
        const double angle = std::numbers::pi * i / 5;
        star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const std::string complaint = complaint_of([&] { tile(outlines::make_outline(star, {})); });
    EXPECT_THAT(complaint, HasSubstr("; sides of 0.0026 m work"));
    EXPECT_NO_THROW(tile(outlines::make_outline(star, {}), {.edge_length = 0.0026}));
}

TEST(NarrowPlaces, ABandIsNarrowAndTheCornersOfAPlateAreNot) {
    const detail::NarrowLimits limits{.width = 0.05, .least_area = 1e-5};
    EXPECT_TRUE(detail::narrow_places(outlines::make_outline(kPlate, {}), limits, {}).empty());
    const outlines::Outline band = outlines::make_outline({{0, 0}, {0.5, 0}, {0.5, 0.02}, {0, 0.02}}, {});
    const auto places = detail::narrow_places(band, limits, {});
    ASSERT_FALSE(places.empty());
    for (const detail::NarrowPlace& place : places) EXPECT_NEAR(place.width, 0.02, 0.002);
}

TEST(NarrowPlaces, LandBetweenAHoleAndTheBoundaryIsNarrow) {
    const outlines::Outline outline = outlines::make_outline(kPlate, {circle({0.2, 0.06}, 0.05)});
    const auto places = detail::narrow_places(outline, {.width = 0.05, .least_area = 1e-5}, {});
    ASSERT_FALSE(places.empty());
    EXPECT_NEAR(places.front().width, 0.01, 0.001);
    EXPECT_NEAR(places.front().place.x, 0.2, 0.01);
    EXPECT_NEAR(places.front().place.y, 0.005, 0.001);
}

TEST(Blunt, OnlySharpTipsLoseTheirEnds) {
    const detail::BluntLimits limits{.tip = 1e-4, .all = 1e-3};
    EXPECT_EQ(detail::blunt(outlines::make_outline(kPlate, {}), 0.05, limits, {}).lost_area, 0.0);
    const outlines::Outline wedge = outlines::make_outline({{0, 0}, {0.5, -0.05}, {0.5, 0.05}}, {});
    const detail::BluntOutline result = detail::blunt(wedge, 0.05, limits, {});
    EXPECT_GT(result.lost_area, 0.5e-4);
    EXPECT_LE(result.lost_area, 1e-4);
    EXPECT_NEAR(area_of(result.outline), area_of(wedge) - result.lost_area, 1e-12);
}

TEST(SizeField, GrowsFromItsLimitsByABoundedRate) {
    detail::SizeField field(0.026);
    EXPECT_TRUE(field.is_uniform());
    field.limit({0, 0}, 0.005);
    field.limit({0.2, 0.1}, 0.01);
    EXPECT_DOUBLE_EQ(field.at({0, 0}), 0.005);
    EXPECT_DOUBLE_EQ(field.at({0.2, 0.1}), 0.01);
    EXPECT_DOUBLE_EQ(field.at({1, 1}), 0.026);
    for (int i = 0; i < 400; ++i) {
        const Point2 here{-0.1 + 0.001 * i, 0.0004 * i};
        const Point2 there{here.x + 0.001, here.y};
        EXPECT_LE(std::abs(field.at(here) - field.at(there)), detail::SizeField::kGrowth * 0.001 + 1e-15);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
