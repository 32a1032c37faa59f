// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/rim_sides.hpp>
#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <numbers>
#include <random>

namespace fretwork::tiling::detail {
namespace THIS_TEST {

using geometry::Point2;
using geometry::Polygon;

/// One cell that is the whole outline.
Dual one_cell(const Polygon& polygon) {
    Dual dual;
    dual.cells.emplace_back();
    double along = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        dual.cells.front().emplace_back(i);
        dual.vertices.push_back({polygon[i], LoopIndex(0), true, along});
        along += distance(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    return dual;
}

Polygon divided(const Polygon& polygon, double wanted_side, double smallest_side = 0) {
    const outlines::Outline outline{polygon, {}};
    const SizeField field(wanted_side);
    const Rim rim = sample_rim(outline, {field, std::numbers::sqrt3}, {});
    Dual dual = one_cell(polygon);
    divide_long_rim_sides(dual, rim, {field, smallest_side}, {});
    return polygon_of(dual, 0);
}

TEST(LongRimSides, OfHalfAHexagonAreDividedSoThatAllItsSidesAreEqual) {
    const double height = 0.5 * std::numbers::sqrt3;
    const Polygon polygon = divided({{-1, 0}, {1, 0}, {0.5, height}, {-0.5, height}}, 1);
    ASSERT_EQ(polygon.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(distance(polygon[i], polygon[(i + 1) % 5]), 1, 1e-12) << "side " << i;
    EXPECT_TRUE(geometry::is_convex(polygon));
}

TEST(LongRimSides, StayWhereTheOtherSidesAreAsLongOrTheHalvesWouldBeTooShort) {
    const Polygon square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    EXPECT_EQ(divided(square, 1), square);
    const double height = 0.5 * std::numbers::sqrt3;
    const Polygon half{{-1, 0}, {1, 0}, {0.5, height}, {-0.5, height}};
    EXPECT_EQ(divided(half, 1, 1.01), half);
}

TEST(ConvexPlace, IsTheWantedOneOutsideOfTheSideAndOnTheSideOtherwise) {
    const StraightSide side{{0, 0}, {2, 0}};
    EXPECT_EQ(convex_place({1, -0.1}, side), (Point2{1, -0.1}));
    EXPECT_EQ(convex_place({1.5, 0}, side), (Point2{1.5, 0}));
    EXPECT_EQ(convex_place({1.5, 0.3}, side), (Point2{1.5, 0}));
}

TEST(ConvexPlace, KeepsAConvexCellConvexInWhateverDirectionTheSideRuns) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> coordinate(-10, 10);
    for (int i = 0; i < 1000; ++i) {
        const Point2 from{coordinate(random), coordinate(random)};
        const Point2 to{coordinate(random), coordinate(random)};
        const Point2 along = to - from;
        const Point2 behind = between(from, to, 0.4) + Point2{-along.y, along.x};
        const Point2 place = convex_place(between(from, behind, 0.3), {from, to});
        EXPECT_TRUE(geometry::is_convex({from, place, to, behind})) << from.x << " " << from.y;
        // Rounding of coordinates up to 10 needs no more.
        EXPECT_LT(distance(nearest_on_segment(from, to, place), place), 1e-11 * length(along) + 1e-14);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling::detail

namespace fretwork::tiling {
namespace THIS_TEST {

/// The relative spread of the sides of the tiles that have a side on the rim.
double spread_at_rim(const Tessellation& tessellation) {
    std::vector<bool> is_on_rim(tessellation.interface_nodes.size(), false);
    for (const auto& loop : rim_loops(tessellation)) {
        for (const InterfaceIndex node : loop) is_on_rim[static_cast<std::size_t>(node)] = true;
    }
    double count = 0;
    double sum = 0;
    double squares = 0;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        const auto at_rim = [&](InterfaceIndex node) { return is_on_rim[static_cast<std::size_t>(node)]; };
        if (std::ranges::none_of(tessellation.tiles[t].interface_nodes, at_rim)) continue;
        const geometry::Polygon polygon = tile_polygon(tessellation, TileIndex(t));
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const double side = geometry::distance(polygon[i], polygon[(i + 1) % polygon.size()]);
            count += 1;
            sum += side;
            squares += side * side;
        }
    }
    return std::sqrt(squares * count / (sum * sum) - 1);
}

TEST(RimSides, RunAroundTheSurfaceTileByTileAndHoldTheNodesOfTheRim) {
    const auto layout = pattern::paper_layout();
    const auto outline = outlines::read_outline(outlines::example_outline("example_b.svg"));
    const Tessellation tessellation = tessellate(outline, layout, {.edge_length = 0.05}).tessellation;
    const auto lines = rim_sides(tessellation);
    EXPECT_EQ(lines.size(), 1 + outline.holes.size());
    std::vector<std::vector<InterfaceIndex>> nodes;
    for (const auto& line : lines) {
        nodes.emplace_back();
        for (std::size_t i = 0; i < line.size(); ++i) {
            EXPECT_EQ(line[i].to, line[(i + 1) % line.size()].from);
            const auto& corners = tessellation.tiles[line[i].tile].vertices;
            const auto from = std::ranges::find(corners, line[i].from) - corners.begin();
            EXPECT_EQ(corners[(from + 1) % corners.size()], line[i].to) << "the tile lies on the left";
            nodes.back().insert(nodes.back().end(), line[i].nodes.begin(), line[i].nodes.end());
        }
    }
    EXPECT_EQ(nodes, rim_loops(tessellation));
}

/// With the sides of the rim they are all sides, and their nodes are the same from both tiles.
TEST(SharedSides, AreThoseOfTwoTiles) {
    const auto layout = pattern::paper_layout();
    const auto outline = outlines::read_outline(outlines::example_outline("example_b.svg"));
    const Tessellation tessellation = tessellate(outline, layout, {.edge_length = 0.05}).tessellation;
    const std::vector<SharedSide> shared = shared_sides(tessellation);
    std::size_t rim = 0;
    for (const auto& line : rim_sides(tessellation)) rim += line.size();
    std::size_t all = 0;
    for (const Tile& tile : tessellation.tiles) all += tile.vertices.size();
    EXPECT_EQ(2 * shared.size() + rim, all);
    for (const SharedSide& side : shared) {
        EXPECT_LT(side.tiles[0], side.tiles[1]);
        const auto begins = [&](TileIndex tile, VertexIndex from, VertexIndex to) {
            const auto& corners = tessellation.tiles[tile].vertices;
            const auto at = std::ranges::find(corners, from) - corners.begin();
            return corners[(at + 1) % corners.size()] == to;
        };
        EXPECT_TRUE(begins(side.tiles[1], side.from, side.to));
        EXPECT_TRUE(begins(side.tiles[0], side.to, side.from));
        for (const TileIndex tile : side.tiles) {
            for (const InterfaceIndex node : side.nodes)
                EXPECT_NE(std::ranges::find(tessellation.tiles[tile].interface_nodes, node),
                          tessellation.tiles[tile].interface_nodes.end());
        }
    }
}

class Rims : public testing::TestWithParam<std::pair<const char*, outlines::Outline>> {};

/// An outline along a row of hexagons leaves pentagons with sides 1, 1, h, h, sqrt(3): their spread is
/// 0.21 at least, whatever h. Divided, sqrt(3) becomes two sides of 0.87, and the spread can be 0.06; between
/// the two, since rows of tiles seldom run along the rim everywhere.
TEST_P(Rims, HaveMoreEvenSidesThanUndividedRowsOfHexagonsCan) {
    const TessellationResult result =
        tessellate(GetParam().second, pattern::find_node_layout("paper7"), {.edge_length = 0.026});
    EXPECT_LT(spread_at_rim(result.tessellation), 0.14);
}

geometry::Polygon disc(double radius) {
    geometry::Polygon polygon;
    for (int i = 0; i < 200; ++i) {
        const double angle = 2 * std::numbers::pi * i / 200;
        polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return polygon;
}

INSTANTIATE_TEST_SUITE_P(
    Outlines, Rims,
    testing::Values(std::pair{"disc", outlines::Outline{disc(0.25), {}}},
                    std::pair{"rectangle", outlines::Outline{{{0, 0}, {0.5, 0}, {0.5, 0.4}, {0, 0.4}}, {}}}),
    [](const auto& named) { return named.param.first; });

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
