// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/retiling.hpp>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace fretwork::simulation {
namespace THIS_TEST {

using geometry::Point2;
using test::complaint_of;
using testing::HasSubstr;
using tiling::TileIndex;

constexpr double kDegree = std::numbers::pi / 180;

/// A plate of 0.3 x 0.2 m; its left half has one pattern, its right half another.
Project plate(double side = 0.03) {
    const outlines::Outline outline = outlines::make_outline({{0, 0}, {0.3, 0}, {0.3, 0.2}, {0, 0.2}}, {});
    Project project = make_project(outline, {.edge_length = side}, nullptr).project;
    tiling::Tessellation& tessellation = project.tessellation;
    tessellation.patterns =
        pattern::parse_named_patterns(project.layout, std::vector<std::string>{"0-1+1-6", "0-5+5-6"});
    for (const TileIndex tile : tessellation.tiles.indices())
        tessellation.tiles[tile].pattern =
            geometry::centroid(tiling::tile_polygon(tessellation, tile)).x < 0.15 ? 0 : 1;
    return project;
}

Point2 centre(const tiling::Tessellation& tessellation, TileIndex tile) {
    return geometry::centroid(tiling::tile_polygon(tessellation, tile));
}

/// All tiles are compared with all.
TileIndex nearest_by_search(const tiling::Tessellation& tessellation, const Point2& place) {
    double least = std::numeric_limits<double>::infinity();
    TileIndex nearest;
    for (const TileIndex tile : tessellation.tiles.indices()) {
        const Point2 at = centre(tessellation, tile);
        const double away = std::hypot(at.x - place.x, at.y - place.y);
        if (away < least) nearest = tile;
        least = std::min(least, away);
    }
    return nearest;
}

TEST(Retiling, EachNewTileTakesThePatternOfTheNearestOldOne) {
    const Project before = plate();
    const CarriedOver carried = carry_over(before, new_tiles(before, {.edge_length = 0.021}));
    const tiling::Tessellation& tiles = carried.project.tessellation;
    EXPECT_GT(tiles.tiles.size(), before.tessellation.tiles.size() * 3 / 2);
    ASSERT_EQ(carried.from.size(), tiles.tiles.size());
    for (const TileIndex tile : tiles.tiles.indices()) {
        const TileIndex from = nearest_by_search(before.tessellation, centre(tiles, tile));
        EXPECT_EQ(carried.from[tile], from);
        EXPECT_EQ(tiles.tiles[tile].pattern, before.tessellation.tiles[from].pattern);
    }
    ASSERT_NO_THROW(tiling::validate(tiles, before.layout));
}

TEST(Retiling, OnTheSameTilesNothingIsAnother) {
    const Project before = plate();
    const CarriedOver carried = carry_over(before, new_tiles(before, {.edge_length = 0.03}));
    const tiling::Tessellation& tiles = carried.project.tessellation;
    EXPECT_EQ(tiles.interface_nodes, before.tessellation.interface_nodes);
    for (const TileIndex tile : tiles.tiles.indices()) {
        EXPECT_EQ(carried.from[tile], tile);
        EXPECT_EQ(tiles.tiles[tile].pattern, before.tessellation.tiles[tile].pattern);
    }
}

/// One of each kind: by side, box, circle, nearest points and tiles, and each by number.
LoadCase every_kind() {
    LoadCase load_case;
    load_case.name = "every kind";
    load_case.supports = {{NodesAtSide{Side::Left}, mechanics::DofSet::all()},
                          {NodesById{{3, 4}}, mechanics::DofSet::translations()}};
    load_case.loads = {
        {NodesInBox{{0.2, -1, 1, 1}}, {0, 0, -1}, Eigen::Vector3d::Zero(), LoadCase::Amount::Total},
        {NodesInCircle{{0.1, 0.1}, 0.1}, {0, 0, -1}, Eigen::Vector3d::Zero(), LoadCase::Amount::Total},
        {NodesById{{9}}, {0, 0, -1}, Eigen::Vector3d::Zero(), LoadCase::Amount::Each}};
    load_case.prescribed = {{NodesNearest{{{0.3, 0.1}}}, mechanics::Dof::uz, 0.01},
                            {NodesById{{1, 2}}, mechanics::Dof::ux, 0.01},
                            {NodesById{{1, 2}}, mechanics::Dof::uy, 0.01}};
    load_case.area_loads = {{LoadCase::AreaLoad::Tiles{{0, 1, 2}}, {0, 0, -2}},
                            {Selection(NodesById{{5}}), {0, 0, -2}}};
    return load_case;
}

TEST(Retiling, SelectionsByPlaceStayAndThoseByNumberGo) {
    Project before = plate();
    before.load_cases = {every_kind()};
    const CarriedOver carried = carry_over(before, new_tiles(before, {.edge_length = 0.021}));
    EXPECT_EQ(carried.dropped.supports, 1);
    EXPECT_EQ(carried.dropped.loads, 2) << "one on nodes, one on the area of nodes";
    EXPECT_EQ(carried.dropped.prescribed, 1) << "two components of one entry";
    const LoadCase& after = carried.project.load_cases.front();
    const LoadCase old = every_kind();
    EXPECT_EQ(after.supports, std::vector{old.supports.front()});
    EXPECT_EQ(after.loads, (std::vector{old.loads[0], old.loads[1]}));
    EXPECT_EQ(after.prescribed, std::vector{old.prescribed.front()});
    ASSERT_EQ(after.area_loads.size(), 1U);
    const auto& tiles = std::get<LoadCase::AreaLoad::Tiles>(after.area_loads.front().where).numbers;
    EXPECT_GT(tiles.size(), 3U) << "the new tiles are smaller";
    for (const int tile : tiles) EXPECT_LE(carried.from[TileIndex(tile)].value, 2);
}

/// Where the interface nodes are the same, their numbers mean the same places.
TEST(Retiling, NumbersStayWhereTheNodesAreTheSame) {
    Project before = plate();
    before.load_cases = {every_kind()};
    const CarriedOver same = carry_over(before, new_tiles(before, {.edge_length = 0.03}));
    EXPECT_EQ(same.dropped.supports + same.dropped.loads + same.dropped.prescribed, 0);
    EXPECT_EQ(same.project.load_cases, before.load_cases);
}

TEST(Retiling, KeepsTheMeanSideIfNoneIsGiven) {
    const Project before = plate();
    const double side = tiling::mean_tile_side(before.tessellation);
    const NewTiles tiles = new_tiles(before, {.angle = 10.0 * kDegree});
    EXPECT_NEAR(tiles.report.mean_side, side, 0.05 * side);
}

TEST(Retiling, IsTheSameInOneCallAsInItsParts) {
    Project before = plate();
    before.load_cases = {every_kind()};
    const RetilingOptions options{.edge_length = 0.021};
    const RetiledProject whole = retile(before, options, nullptr);
    const NewTiles tiles = new_tiles(before, options);
    const CarriedOver carried = carry_over(before, tiles);
    EXPECT_EQ(project_text(whole.project), project_text(carried.project));
    EXPECT_EQ(whole.report.tiles, tiles.report.tiles);
    EXPECT_EQ(whole.dropped.loads, carried.dropped.loads);
}

TEST(Retiling, PaintsTheNewTilesIfItIsAskedTo) {
    const Project before = plate();
    const RetiledProject made =
        retile(before, {.edge_length = 0.021, .painting = PaintOnePattern{"2-4+4-6"}}, nullptr);
    for (const TileIndex tile : made.project.tessellation.tiles.indices())
        EXPECT_EQ(tiling::pattern_of(made.project.tessellation, tile)->id, "2-4+4-6");
    const RetilingOptions foreign{.edge_length = 0.021, .painting = PaintOnePattern{"0-99"}};
    EXPECT_THAT(complaint_of([&] { (void)retile(before, foreign, nullptr); }), HasSubstr("0-99"));
}

TEST(Retiling, TileModelsStayByPlace) {
    Project before = plate();
    before.tile_models = {{"full", {TileIndex(0), TileIndex(4)}}};
    const CarriedOver carried = carry_over(before, new_tiles(before, {.edge_length = 0.021}));
    const std::vector<std::string> models = models_by_tile(carried.project);
    ASSERT_EQ(models.size(), carried.from.size());
    for (std::size_t t = 0; t < models.size(); ++t) {
        const int from = carried.from[t].value;
        EXPECT_EQ(models[t], from == 0 || from == 4 ? "full" : "");
    }
}

TEST(Retiling, AnotherLayoutLeavesTilesUnpaintedAndItsLibrary) {
    Project before = plate();
    before.library_path = "lib.db";
    before.library_hash = "abc";
    const pattern::NodeLayout other = pattern::find_node_layout("paper8");
    const CarriedOver carried = carry_over(before, new_tiles(before, {.edge_length = 0.03, .layout = other}));
    EXPECT_EQ(carried.project.layout.name(), "paper8");
    EXPECT_TRUE(carried.project.tessellation.patterns.empty());
    for (const tiling::Tile& tile : carried.project.tessellation.tiles) EXPECT_EQ(tile.pattern, -1);
    EXPECT_EQ(carried.project.library_path, "");
    ASSERT_NO_THROW(tiling::validate(carried.project.tessellation, other));
}

TEST(Retiling, AnEntryThatFindsNoNodeIsNamed) {
    Project before = plate(0.02);
    LoadCase load_case;
    load_case.name = "pin";
    const Point2& node = before.tessellation.interface_nodes[40];
    load_case.supports = {
        {NodesInBox{{node.x - 1e-6, node.y - 1e-6, node.x + 1e-6, node.y + 1e-6}}, mechanics::DofSet::all()}};
    before.load_cases = {load_case};
    const NewTiles tiles = new_tiles(before, {.edge_length = 0.037});
    const std::string complaint = complaint_of([&] { (void)carry_over(before, tiles); });
    EXPECT_THAT(complaint, testing::AllOf(HasSubstr("pin"), HasSubstr("/supports/0"), HasSubstr("box")));
}

/// The angle to the x axis of the line from a tile's centre to that of its nearest neighbour; it is the same
/// again after 60 degrees.
std::vector<double> row_angles(const tiling::Tessellation& tiles) {
    std::vector<double> angles;
    for (const TileIndex tile : tiles.tiles.indices()) {
        if (tiles.tiles[tile].vertices.size() != 6) continue;
        const Point2 at = centre(tiles, tile);
        double least = std::numeric_limits<double>::infinity();
        double angle = 0.0;
        for (const TileIndex other : tiles.tiles.indices()) {
            const Point2 there = centre(tiles, other);
            const double away = std::hypot(there.x - at.x, there.y - at.y);
            if (other == tile || away >= least) continue;
            least = away;
            angle = std::atan2(there.y - at.y, there.x - at.x);
        }
        angles.push_back(angle - 60 * kDegree * std::round(angle / (60 * kDegree)));
    }
    std::ranges::sort(angles);
    return angles;
}

TEST(Retiling, RowsOfTilesLieAtTheWantedAngle) {
    const Project before = plate();
    for (const double wanted : {0.0, 10.0, -20.0}) {
        const NewTiles tiles = new_tiles(before, {.edge_length = 0.01, .angle = wanted * kDegree});
        const std::vector<double> angles = row_angles(tiles.tessellation);
        // The relaxation moves tiles near the rim.
        EXPECT_NEAR(angles[angles.size() / 2] / kDegree, wanted, 2.0) << tiles.report.start;
        EXPECT_NEAR(tiles.report.mean_side, 0.01, 0.0005);
        EXPECT_GE(tiles.report.largest_side, tiles.report.mean_side);
    }
    const auto endless = std::numeric_limits<double>::infinity();
    EXPECT_THAT(complaint_of([&] { (void)new_tiles(before, {.edge_length = 0.03, .angle = endless}); }),
                HasSubstr("angle"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
