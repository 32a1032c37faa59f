// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <map>
#include <numbers>
#include <set>

namespace fretwork::tiling {
namespace THIS_TEST {

using geometry::Point2;
using geometry::Polygon;
using test::complaint_of;
using testing::AllOf;
using testing::HasSubstr;

/// The side of the paper's hexagon, inscribed in a circle of diameter 0.03 sqrt(3) m.
const double kPaperSide = 0.015 * std::numbers::sqrt3;

pattern::NodeLayout paper_layout() {
    return pattern::find_node_layout("paper7");
}

TessellationResult tile(const outlines::Outline& outline, double side = kPaperSide) {
    TessellationOptions options;
    options.edge_length = side;
    return tessellate(outline, paper_layout(), options);
}

Polygon circle(Point2 center, double radius, int points) {
    Polygon polygon;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        polygon.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
    }
    return polygon;
}

/// The closed curves of sides that only one tile has.
std::vector<Polygon> rims_of(const Tessellation& tessellation) {
    std::set<std::pair<int, int>> sides;
    for (const Tile& t : tessellation.tiles) {
        for (std::size_t i = 0; i < t.vertices.size(); ++i)
            sides.insert({t.vertices[i], t.vertices[(i + 1) % t.vertices.size()]});
    }
    std::map<int, int> next;
    for (const auto& [from, to] : sides) {
        if (!sides.contains({to, from})) next[from] = to;
    }
    std::vector<Polygon> rims;
    while (!next.empty()) {
        rims.emplace_back();
        for (auto at = next.begin(); at != next.end();) {
            rims.back().push_back(tessellation.vertices[at->first]);
            const int to = at->second;
            next.erase(at);
            at = next.find(to);
        }
    }
    return rims;
}

/// Convex tiles that share whole sides and whose rim is a simple outline with the right number of holes
/// cannot overlap.
void expect_sound(const TessellationResult& result, const outlines::Outline& outline, std::size_t holes) {
    const Tessellation& tessellation = result.tessellation;
    ASSERT_NO_THROW(validate(tessellation, paper_layout()));
    std::vector<Polygon> rims = rims_of(tessellation);
    const auto largest = std::max_element(rims.begin(), rims.end(), [](const Polygon& a, const Polygon& b) {
        return std::abs(geometry::signed_area(a)) < std::abs(geometry::signed_area(b));
    });
    std::iter_swap(rims.begin(), largest);
    outlines::Outline rim;
    ASSERT_NO_THROW(rim = outlines::make_outline(rims.front(), {rims.begin() + 1, rims.end()}));
    EXPECT_EQ(rim.holes.size(), holes);
    double sum = 0;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t)
        sum += geometry::signed_area(tile_polygon(tessellation, TileIndex(t)));
    EXPECT_NEAR(sum, area_of(rim), 1e-9 * sum);
    const double share = result.report.covered_share + result.report.outside_share;
    EXPECT_NEAR(sum, share * area_of(outline), 1e-9 * sum);
}

/// Where a corner cuts a row of tiles, it may leave a triangle that is a tenth of a tile: a knot of bars.
TEST(Tessellate, LeavesNoTinyTilesAtTheCornersOfARectangle) {
    constexpr std::array<std::array<double, 2>, 4> kSizes = {
        {{0.310, 0.265}, {0.271, 0.401}, {0.909, 0.517}, {0.574, 0.260}}};
    for (const auto& [width, height] : kSizes) {
        const TessellationResult result =
            tile(outlines::make_outline({{0, 0}, {width, 0}, {width, height}, {0, height}}, {}));
        const double hexagon = 1.5 * std::numbers::sqrt3 * kPaperSide * kPaperSide;
        for (std::size_t t = 0; t < result.tessellation.tiles.size(); ++t)
            EXPECT_GT(geometry::signed_area(tile_polygon(result.tessellation, TileIndex(t))), 0.25 * hexagon)
                << width << " x " << height << ", tile " << t;
    }
}

class Examples : public testing::TestWithParam<const char*> {};

TEST_P(Examples, AreTiledSoundlyWithTheWantedMeanSideAndNearlyAllHexagonsInside) {
    const outlines::Outline outline = outlines::read_outline(outlines::example_outline(GetParam()));
    const TessellationResult result = tile(outline);
    expect_sound(result, outline, outline.holes.size());
    EXPECT_NEAR(result.report.mean_side, kPaperSide, 0.01 * kPaperSide);
    EXPECT_GT(result.report.covered_share, 0.99);
    EXPECT_LE(result.report.covered_share, 1.0 + 1e-12);
    EXPECT_LT(result.report.outside_share, 0.01);
    EXPECT_EQ(result.report.refined_share, 0.0);
    // Around the hole of example A, which has 62 tiles inside, rows of hexagons have to end.
    EXPECT_GT(result.report.inner_hexagon_share, outline.holes.empty() ? 0.9 : 0.8);
    EXPECT_GT(result.report.smallest_side, 0.5 * kPaperSide);
    double longest = 0.0;
    for (const TileIndex tile : result.tessellation.tiles.indices()) {
        const geometry::Polygon polygon = tile_polygon(result.tessellation, tile);
        for (std::size_t i = 0; i < polygon.size(); ++i)
            longest = std::max(longest, geometry::distance(polygon[i], polygon[(i + 1) % polygon.size()]));
    }
    EXPECT_DOUBLE_EQ(result.report.largest_side, longest);
    EXPECT_GT(result.report.smallest_angle, 40 * std::numbers::pi / 180);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Examples, testing::Values("example_a.svg", "example_b.svg", "example_c.svg"));

TEST(Tessellate, ARectangleIsCoveredToItsCorners) {
    const outlines::Outline outline = outlines::read_outline(outlines::example_outline("specimen.svg"));
    const TessellationResult result = tile(outline);
    expect_sound(result, outline, 0);
    EXPECT_NEAR(result.report.covered_share, 1.0, 1e-12);
    EXPECT_NEAR(result.report.mean_side, kPaperSide, 0.01 * kPaperSide);
}

TEST(Tessellate, TheResultDoesNotDependOnThreadsAndIsTheSameEachTime) {
    const outlines::Outline outline = outlines::read_outline(outlines::example_outline("specimen.svg"));
    TessellationOptions options;
    options.edge_length = kPaperSide;
    options.threads = 1;
    const Tessellation first = tessellate(outline, paper_layout(), options).tessellation;
    options.threads = 3;
    const Tessellation second = tessellate(outline, paper_layout(), options).tessellation;
    EXPECT_EQ(first.vertices, second.vertices);
    EXPECT_EQ(first.interface_nodes, second.interface_nodes);
    ASSERT_EQ(first.tiles.size(), second.tiles.size());
    for (std::size_t t = 0; t < first.tiles.size(); ++t) {
        EXPECT_EQ(first.tiles[t].vertices, second.tiles[t].vertices);
        EXPECT_EQ(first.tiles[t].interface_nodes, second.tiles[t].interface_nodes);
    }
}

TEST(Tessellate, EachInterfaceNodeIsOnOneTileAtTheRimOrSharedByTwo) {
    const TessellationResult result = tile(outlines::read_outline(outlines::example_outline("specimen.svg")));
    std::vector<int> uses(result.tessellation.interface_nodes.size());
    std::size_t rim_sides = 0;
    for (const Polygon& rim : rims_of(result.tessellation)) rim_sides += rim.size();
    for (const Tile& t : result.tessellation.tiles) {
        for (const InterfaceIndex node : t.interface_nodes) ++uses[static_cast<std::size_t>(node.value)];
    }
    EXPECT_EQ(static_cast<std::size_t>(std::count(uses.begin(), uses.end(), 1)), rim_sides);
    EXPECT_EQ(static_cast<std::size_t>(std::count(uses.begin(), uses.end(), 2)), uses.size() - rim_sides);
}

TEST(Tessellate, SeveralInterfaceNodesOnASideRunTheOtherWayForTheNeighbour) {
    pattern::NodeLayoutDescription description = paper_layout().description();
    description.name = "two";
    description.interface = {pattern::Rational(1, 4), pattern::Rational(3, 4)};
    const pattern::NodeLayout layout(description);
    TessellationOptions options;
    options.edge_length = 0.03;
    const auto result =
        tessellate(outlines::make_outline({{0, 0}, {0.3, 0}, {0.3, 0.2}, {0, 0.2}}, {}), layout, options);
    EXPECT_NO_THROW(validate(result.tessellation, layout));
    EXPECT_EQ(result.tessellation.interface_nodes.size() % 2, 0U);
}

TEST(Tessellate, InARegularRegionNeighboursHaveTheSameOrientation) {
    const TessellationResult result =
        tile(outlines::make_outline({{0, 0}, {0.5, 0}, {0.5, 0.4}, {0, 0.4}}, {}));
    const Tessellation& tessellation = result.tessellation;
    std::map<int, int> hexagons_by_facing;  // of the first side, to the nearest 60 degrees
    std::vector<double> facings;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        const Polygon p = tile_polygon(tessellation, TileIndex(t));
        const bool is_inner = std::all_of(p.begin(), p.end(), [](const Point2& v) {
            return v.x > 0.01 && v.x < 0.49 && v.y > 0.01 && v.y < 0.39;
        });
        if (p.size() != 6 || !is_inner) continue;  // the tiles at the rim are not regular
        facings.push_back(std::atan2(p[0].x - p[1].x, p[1].y - p[0].y));
    }
    for (const double facing : facings) {
        EXPECT_LT(std::abs(std::remainder(facing + std::numbers::pi / 2, 2 * std::numbers::pi)),
                  65 * std::numbers::pi / 180);  // down, within 30 degrees and half a sector
        ++hexagons_by_facing[static_cast<int>(
            std::lround(std::remainder(facing - facings[0], 2 * std::numbers::pi) / (std::numbers::pi / 3)))];
    }
    const auto more = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto most = std::max_element(hexagons_by_facing.begin(), hexagons_by_facing.end(), more);
    EXPECT_GT(most->second, 0.9 * static_cast<double>(facings.size()));
}

TEST(Tessellate, TilesAreNumberedFromLeftToRight) {
    const TessellationResult result =
        tile(outlines::make_outline({{0, 0}, {0.4, 0}, {0.4, 0.1}, {0, 0.1}}, {}));
    double last = -1;
    for (std::size_t t = 0; t < result.tessellation.tiles.size(); ++t) {
        const double x = geometry::centroid(tile_polygon(result.tessellation, TileIndex(t))).x;
        EXPECT_GE(x, last);
        last = x;
    }
}

/// A wavy shape or a crooked polygon with up to two holes, by chance.
struct RandomOutline {
    explicit RandomOutline(std::uint64_t seed) : state(seed * 0x9e3779b97f4a7c15U + 1) {}
    double next(double low, double high) {  // xorshift64*
        state ^= state >> 12U;
        state ^= state << 25U;
        state ^= state >> 27U;
        return low + (high - low) * static_cast<double>((state * 0x2545f4914f6cdd1dU) >> 11U) * 0x1p-53;
    }
    outlines::Outline make() {
        const double size = next(0.09, 0.2);
        const double flatness = next(0.5, 1);
        std::array<double, 4> waves{};
        std::array<double, 4> phases{};
        for (std::size_t k = 0; k < 4; ++k) {
            waves[k] = next(0, 0.3 / static_cast<double>(k + 2));
            phases[k] = next(0, 6.28);
        }
        const int count = next(0, 1) < 0.3 ? static_cast<int>(next(5, 13)) : 150;
        Polygon boundary;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            double r = size;
            for (std::size_t k = 0; k < 4; ++k)
                r += size * waves[k] * std::cos(static_cast<double>(k + 2) * angle + phases[k]);
            boundary.push_back({r * std::cos(angle), flatness * r * std::sin(angle)});
        }
        std::vector<Polygon> holes;
        const int hole_count = static_cast<int>(next(0, 3));
        for (int h = 0; h < hole_count; ++h) {
            const double x = (h == 0 ? 1 : -1) * next(0.3, 0.4) * size;
            const double r = next(0.1, 0.2) * size * flatness;
            holes.push_back(circle({x, 0}, r, next(0, 1) < 0.5 ? static_cast<int>(next(3, 7)) : 40));
        }
        return outlines::make_outline(boundary, holes);
    }
    std::uint64_t state;
};

TEST(Tessellate, RandomOutlinesAreTiledSoundly) {
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
        SCOPED_TRACE(seed);
        const outlines::Outline outline = RandomOutline(seed).make();
        const TessellationResult result = tile(outline);
        expect_sound(result, outline, outline.holes.size());
        EXPECT_GE(result.report.covered_share, 0.98);
        EXPECT_GE(result.report.smallest_angle, 25 * std::numbers::pi / 180);
        if (result.report.refined_share > 0) continue;
        // Whole numbers of tiles: the fewer, the coarser the steps in which the mean side can be had.
        EXPECT_NEAR(result.report.mean_side / kPaperSide, 1, 0.01 + 0.5 / result.report.tiles);
    }
}

TEST(Tessellate, ScalingTheOutlineScalesTheTiling) {
    const outlines::Outline outline = outlines::make_outline({{0, 0}, {0.3, 0}, {0.25, 0.2}, {0, 0.22}}, {});
    outlines::Outline doubled = outline;
    for (Point2& p : doubled.boundary) p = {2 * p.x, 2 * p.y};
    const TessellationReport one = tile(outline, kPaperSide).report;
    const TessellationReport two = tile(doubled, 2 * kPaperSide).report;
    EXPECT_EQ(one.tiles, two.tiles);
    EXPECT_NEAR(2 * one.mean_side, two.mean_side, 1e-9);
}

TEST(Tessellate, WhatCannotBeTiledIsRefused) {
    const outlines::Outline square = outlines::make_outline({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {});
    EXPECT_THAT(complaint_of([&] { tile(square, 0); }), HasSubstr("edge length of a tessellation is 0"));
    EXPECT_THAT(complaint_of([&] { tile(square, -0.1); }), HasSubstr("from 1e-09 m to 1e+06 m"));
    EXPECT_THAT(complaint_of([&] { tile(square, std::numeric_limits<double>::quiet_NaN()); }),
                HasSubstr("nan"));
    // 1 m2 in at most 100,000 hexagons of 2.598 side^2 each.
    EXPECT_THAT(
        complaint_of([&] { tile(square, 1e-5); }),
        AllOf(HasSubstr("is the unit of the outline right?"), HasSubstr("sides of 0.00196189 m or more")));
}

TEST(Tessellate, AnOutlineThatIsMuchNarrowerThanATileIsRefused) {
    for (const double width : {2e-3, 1e-3, 1e-5}) {
        const outlines::Outline sliver = outlines::make_outline({{0, 0}, {1, 0}, {1, width}, {0, width}}, {});
        EXPECT_THAT(complaint_of([&] { tile(sliver); }), HasSubstr("no tile fits there"));
    }
}

TEST(Tessellate, AnOutlineThatIsFarTooLargeIsRefusedByItsSize) {
    const outlines::Outline huge = outlines::make_outline({{0, 0}, {1e12, 0}, {1e12, 1e12}, {0, 1e12}}, {});
    EXPECT_THAT(complaint_of([&] { tile(huge); }), HasSubstr("1e+12 m wide and 1e+12 m high"));
    const outlines::Outline thread = outlines::make_outline({{0, 0}, {1e5, 0}, {1e5, 1e-9}, {0, 1e-9}}, {});
    EXPECT_THAT(complaint_of([&] { tile(thread); }), HasSubstr("100000 m wide"));
}

TEST(Tessellate, ADiskThatIsHardlyLargerThanATileIsCovered) {
    for (const double size : {0.03, 0.045, 0.06}) {
        const outlines::Outline outline = outlines::make_outline(circle({0, 0}, size, 60), {});
        const TessellationResult result = tile(outline);
        expect_sound(result, outline, 0);
        // A hexagon covers 83 % of the disk around it: more and smaller tiles cover it as the law wants.
        EXPECT_GE(result.report.covered_share, 0.98);
        EXPECT_LE(result.report.tiles, 40);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
