// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/load_cases/load_case_text.hpp>
#include <fretwork/simulation/project/new_project.hpp>

namespace fretwork::simulation {
namespace THIS_TEST {

using test::complaint_of;
using test::honeycomb;
using test::TemporaryFolder;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::string> kStar = {"0-1+1-6"};

std::vector<int> numbers(const std::vector<tiling::InterfaceIndex>& nodes) {
    std::vector<int> list;
    for (const auto node : nodes) list.push_back(node.value);
    return list;
}

LoadCase read(const std::string& text) {
    const TemporaryFolder folder;
    return read_load_case(folder.file("case.json", text));
}

std::string with(const std::string& members) {
    return R"({"format": "fretwork/load-case/1", "name": "x")" + (members.empty() ? "" : ", " + members) +
           "}";
}

TEST(SelectNodes, ByIdIsSortedAndHasNoRepeats) {
    const auto project = honeycomb(2, 2, kStar);
    EXPECT_THAT(numbers(select_nodes(NodesById{{7, 3, 7}}, project.tessellation)), ElementsAre(3, 7));
    EXPECT_THAT(complaint_of([&] { select_nodes(NodesById{{1000}}, project.tessellation); }),
                HasSubstr("there is no interface node 1000"));
}

TEST(SelectNodes, AtASidePicksRimNodesThere) {
    const auto project = honeycomb(4, 3, kStar);
    const auto left = select_nodes(NodesAtSide{Side::Left}, project.tessellation);
    ASSERT_FALSE(left.empty());
    double lowest = 1.0;
    for (const auto& node : project.tessellation.interface_nodes) lowest = std::min(lowest, node.x);
    for (const auto node : left) {
        EXPECT_LE(project.tessellation.interface_nodes[node].x, lowest + 0.026);
    }
    EXPECT_NE(numbers(left), numbers(select_nodes(NodesAtSide{Side::Right}, project.tessellation)));
}

TEST(SelectNodes, InABoxIncludesItsRimAndAnEmptyBoxIsRefused) {
    const auto project = honeycomb(2, 1, kStar);
    const auto& first = project.tessellation.interface_nodes[0];
    const auto picked = select_nodes(NodesInBox{{first.x, first.y, first.x, first.y}}, project.tessellation);
    EXPECT_THAT(numbers(picked), ElementsAre(0));
    EXPECT_THAT(complaint_of([&] {
                    select_nodes(NodesInBox{{9, 9, 10, 10}}, project.tessellation);
                }),
                HasSubstr("no interface node lies in the box"));
}

TEST(SelectNodes, NearestTakesOneNodeForEachPoint) {
    const auto project = honeycomb(2, 1, kStar);
    const auto& nodes = project.tessellation.interface_nodes;
    EXPECT_THAT(numbers(select_nodes(NodesNearest{{{nodes[4].x + 1e-4, nodes[4].y}}}, project.tessellation)),
                ElementsAre(4));
}

TEST(Conditions, ATotalForceIsSharedAndAForceOnEachIsRepeated) {
    const Surface surface = make_surface(honeycomb(3, 2, kStar), nullptr);
    LoadCase load_case = test::cantilever({0, 0, -2});
    const auto sum = [&] {
        Eigen::Vector3d total = Eigen::Vector3d::Zero();
        for (const auto& load : resolve(load_case, surface).loads) total += load.force;
        return total;
    };
    EXPECT_NEAR(sum().z(), -2.0, 1e-15);
    load_case.loads[0].amount = LoadCase::Amount::Each;
    const auto count = select_nodes(NodesAtSide{Side::Right}, surface.tessellation).size();
    EXPECT_NEAR(sum().z(), -2.0 * static_cast<double>(count), 1e-12);
    EXPECT_EQ(resolve(load_case, surface).weights, 0U);
}

TEST(Conditions, AnEntryThatSelectsNothingIsNamed) {
    const Surface surface = make_surface(honeycomb(2, 1, kStar), nullptr);
    const auto complaints = [&](const LoadCase& load_case) {
        return std::vector{complaint_of([&] { (void)resolve(load_case, surface); }),
                           complaint_of([&] { check_selections(load_case, surface.tessellation); }),
                           complaint_of([&] { (void)entry_texts(load_case, surface.tessellation); })};
    };
    const LoadCase whole = test::cantilever({0, 0, 1});
    for (const Selection& nothing : {Selection(NodesById{}), Selection(NodesNearest{})}) {
        LoadCase load_case = whole;
        load_case.supports.push_back({nothing, mechanics::DofSet::all()});
        EXPECT_THAT(complaints(load_case), Each(HasSubstr("/supports/1: selects no interface node")));
        load_case = whole;
        load_case.loads.push_back({nothing, {0, 0, 1}});
        EXPECT_THAT(complaints(load_case), Each(HasSubstr("/loads/1: selects no interface node")));
        load_case = whole;
        load_case.prescribed = {{nothing, mechanics::Dof::uz, 0.001}};
        EXPECT_THAT(complaints(load_case), Each(HasSubstr("/prescribed/0: selects no interface node")));
        load_case = whole;
        load_case.area_loads = {{nothing, {0, 0, -1}}};
        EXPECT_THAT(complaints(load_case), Each(HasSubstr("/loads/1: selects no interface node")));
    }
    LoadCase load_case = whole;
    load_case.area_loads = {{LoadCase::AreaLoad::Tiles{}, {0, 0, -1}}};
    EXPECT_THAT(complaints(load_case), Each(HasSubstr("/loads/1/tiles: is empty")));
}

TEST(Conditions, GravityIsTheWeightOfAllBeams) {
    Surface surface = make_surface(honeycomb(3, 2, kStar), nullptr);
    surface.setting.material.density = 1240;
    LoadCase load_case;
    load_case.gravity = {0, 0, -9.81};
    double length = 0.0;
    const tiling::TessellationFan fan = surface_fan(surface);
    for (const auto& edge : fan.edges) {
        const auto& a = fan.nodes[edge.nodes[0]];
        const auto& b = fan.nodes[edge.nodes[1]];
        length += std::hypot(a.x - b.x, a.y - b.y);
    }
    double weight = 0.0;
    const Conditions conditions = resolve(load_case, surface);
    for (const auto& load : conditions.loads) weight += load.force.z();
    EXPECT_EQ(conditions.weights, conditions.loads.size());
    EXPECT_NEAR(weight, -length * surface.setting.section.area * 1240 * 9.81, 1e-12);
}

TEST(Conditions, GravityNeedsADensity) {
    Surface surface = make_surface(honeycomb(3, 2, kStar), nullptr);
    LoadCase load_case = test::cantilever({0, 0, -2});
    surface.setting.material.density = 0.0;
    EXPECT_FALSE(resolve(load_case, surface).loads.empty());
    load_case.gravity = {0, 0, -9.81};
    EXPECT_THAT(complaint_of([&] { resolve(load_case, surface); }),
                AllOf(HasSubstr("load case 'cantilever'"), HasSubstr("/gravity"), HasSubstr("density 0")));
}

TEST(Conditions, EntriesMayAgreeOnANodeButNotContradictEachOther) {
    const Surface surface = make_surface(test::honeycomb(3, 2, {"0-1+1-6"}), nullptr);
    LoadCase load_case = test::cantilever({0, 0, 0});
    load_case.prescribed = {{NodesById{{1, 2}}, mechanics::Dof::uz, 0.01},
                            {NodesById{{2}}, mechanics::Dof::uz, 0.01}};
    EXPECT_EQ(resolve(load_case, surface).prescribed.size(), 2U);
    load_case.prescribed[1].value = 0.02;
    EXPECT_THAT(
        complaint_of([&] { resolve(load_case, surface); }),
        testing::AllOf(HasSubstr("/prescribed/1"), HasSubstr("0.02 at interface node 2"), HasSubstr("0.01")));
}

TEST(Conditions, AnEntryThatPicksNothingIsNamed) {
    const Surface surface = make_surface(honeycomb(2, 1, kStar), nullptr);
    LoadCase load_case = test::cantilever({0, 0, 1});
    load_case.loads.push_back({NodesInBox{{5, 5, 6, 6}}, {0, 0, 1}, {0, 0, 0}, LoadCase::Amount::Each});
    EXPECT_THAT(complaint_of([&] { resolve(load_case, surface); }),
                AllOf(HasSubstr("load case 'cantilever'"), HasSubstr("/loads/1")));
}

TEST(LoadCaseFile, ReadsEveryKindOfEntry) {
    const LoadCase load_case = read(with(R"("description": "d", "gravity": [0, 0, -9.81],
        "supports": [{"side": "left", "fixed": ["ux", "rz"]}, {"nodes": [1, 2], "fixed": ["uz"]}],
        "loads": [{"box": [0, 0, 1, 1], "force": [1, 2, 3]}, {"nearest": [[0, 1]], "moment": [4, 5, 6], "amount": "total"}],
        "prescribed": [{"side": "top", "uz": 0.01, "rx": 0.2}])"));
    ASSERT_EQ(load_case.supports.size(), 2U);
    EXPECT_TRUE(load_case.supports[0].fixed[mechanics::Dof::rz]);
    EXPECT_FALSE(load_case.supports[0].fixed[mechanics::Dof::uz]);
    EXPECT_EQ(load_case.loads[0].force, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(load_case.loads[1].moment, Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(load_case.loads[1].amount, LoadCase::Amount::Total);
    ASSERT_EQ(load_case.prescribed.size(), 2U);
    EXPECT_EQ(load_case.prescribed[1].dof, mechanics::Dof::rx);
    EXPECT_EQ(load_case.gravity, Eigen::Vector3d(0, 0, -9.81));
}

TEST(LoadCaseFile, RefusesUnknownKeysAndBadValuesWithTheirPlace) {
    const std::vector<std::pair<std::string, std::string>> faults = {
        {R"("load": [])", "/load: unknown key 'load'; did you mean 'loads'?"},
        {R"("loads": [{"force": [0, 0, 1]}])", "/loads/0: must pick its nodes by exactly one of"},
        {R"("loads": [{"nodes": [1], "side": "left", "force": [0, 0, 1]}])",
         "/loads/0: must pick its nodes by exactly one of"},
        {R"("loads": [{"nodes": [1]}])", "/loads/0: has neither a force nor a moment"},
        {R"("loads": [{"nodes": [], "force": [0, 0, 1]}])", "/loads/0/nodes: is empty"},
        {R"("loads": [{"nodes": [-1], "force": [0, 0, 1]}])", "/loads/0/nodes/0: is -1"},
        {R"("loads": [{"nodes": [1], "force": [0, 1]}])", "/loads/0/force: has 2 elements"},
        {R"("supports": [{"side": "lefft", "fixed": []}])", "did you mean 'left'?"},
        {R"("supports": [{"side": "left", "fixed": ["u"]}])", "/supports/0/fixed/0: unknown choice 'u'"},
        {R"("supports": [{"box": [1, 0, 0, 1], "fixed": []}])", "/supports/0/box: is [1,0,0,1]"},
        {R"("prescribed": [{"side": "top"}])", "/prescribed/0: prescribes nothing"},
        {R"("loads": [{"nodes": [1], "force": [0, 0, 1e308]}])", "/loads/0/force/2: is 1e+308, where"},
        {R"("loads": [{"nodes": [1], "moment": [1e308, 0, 0]}])", "1e+30 (N m)"},
        {R"("prescribed": [{"side": "top", "rx": 1e7}])", "/prescribed/0/rx: is"},
        {R"("gravity": [0, 0, -1e13])", "/gravity/2: is"},
        {R"("gravity": 9.81)", "/gravity: is 9.81, where an array is needed"},
    };
    for (const auto& [members, complaint] : faults) {
        EXPECT_THAT(complaint_of([&] { read(with(members)); }), HasSubstr(complaint)) << members;
    }
    EXPECT_THAT(complaint_of([] { read(R"({"format": "fretwork/load-case/1"})"); }),
                HasSubstr("'name' is missing"));
    EXPECT_THAT(complaint_of([] { read(with("")).name.clear(), read("{"); }), HasSubstr("malformed JSON"));
    EXPECT_THAT(complaint_of([] { read_load_case("nowhere.json"); }), HasSubstr("nowhere.json"));
}

// ---- area loads ----

const NodesInBox kEverywhere{{-10, -10, 10, 10}};

double area_of(const tiling::Tessellation& tessellation, std::size_t tile) {
    return geometry::signed_area(tiling::tile_polygon(tessellation, tiling::TileIndex(tile)));
}

Eigen::Vector3d total_force(const Conditions& conditions) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const mechanics::NodalLoad& load : conditions.loads) sum += load.force;
    return sum;
}

TEST(AreaLoad, AddsUpToItsPressureTimesTheAreaThatBearsIt) {
    const Surface surface = make_surface(test::honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    const tiling::Tessellation& tessellation = surface.tessellation;
    const Eigen::Vector3d pressure(1.0, 0.0, -50.0);
    double whole = 0.0;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) whole += area_of(tessellation, t);
    LoadCase load_case;
    load_case.name = "snow";
    load_case.area_loads = {{Selection(kEverywhere), pressure}};
    EXPECT_LT((total_force(resolve(load_case, surface)) - whole * pressure).norm(), 1e-12);
    load_case.area_loads = {{LoadCase::AreaLoad::Tiles{{2, 5}}, pressure}};
    const double two = area_of(tessellation, 2) + area_of(tessellation, 5);
    const Conditions conditions = resolve(load_case, surface);
    EXPECT_LT((total_force(conditions) - two * pressure).norm(), 1e-12);
    for (const mechanics::NodalLoad& load : conditions.loads) {
        const auto& nodes = tessellation.tiles[2].interface_nodes;
        const auto& others = tessellation.tiles[5].interface_nodes;
        const tiling::InterfaceIndex node(load.node.value);
        EXPECT_TRUE(std::ranges::find(nodes, node) != nodes.end() ||
                    std::ranges::find(others, node) != others.end());
    }
}

TEST(AreaLoad, OfSomeNodesIsThatOfThePartsOfTheirTiles) {
    const Surface surface = make_surface(test::honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    const tiling::Tessellation& tessellation = surface.tessellation;
    const auto shared = tessellation.tiles[0].interface_nodes;
    int tiles_of_first = 0;
    for (const tiling::Tile& tile : tessellation.tiles)
        tiles_of_first += static_cast<int>(std::ranges::count(tile.interface_nodes, shared.front()));
    LoadCase load_case;
    load_case.name = "snow";
    load_case.area_loads = {{Selection(NodesById{{shared.front().value}}), {0, 0, -1}}};
    // All hexagons are equal, and have six nodes.
    EXPECT_NEAR(total_force(resolve(load_case, surface)).z(), -tiles_of_first * area_of(tessellation, 0) / 6,
                1e-12);
}

TEST(AreaLoad, OnATileThatThereIsNotIsRefusedWithItsPlace) {
    const Surface surface = make_surface(test::honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    LoadCase load_case = test::cantilever({0, 0, 1});
    load_case.area_loads = {{LoadCase::AreaLoad::Tiles{{12}}, {0, 0, -1}}};
    EXPECT_THAT(complaint_of([&] { check_selections(load_case, surface.tessellation); }),
                AllOf(HasSubstr("/loads/1/tiles"), HasSubstr("no tile 12")));
    load_case.area_loads = {{Selection(NodesInBox{{9, 9, 10, 10}}), {0, 0, -1}}};
    EXPECT_THAT(complaint_of([&] { (void)resolve(load_case, surface); }), HasSubstr("/loads/1"));
}

// ---- line loads ----

LoadCase::Load line_load(const Selection& where, const Eigen::Vector3d& per_length) {
    return {where, per_length, Eigen::Vector3d::Zero(), LoadCase::Amount::PerLength};
}

// The left rim of a honeycomb is a zigzag of six sides, which is longer than what it covers.
TEST(LineLoad, IsForcePerLengthTimesTheLengthAlongTheSide) {
    const Surface surface = make_surface(test::honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    const Eigen::Vector3d per_length(0.5, 0.0, -2.0);
    LoadCase load_case;
    load_case.name = "rail";
    load_case.loads = {line_load(NodesAtSide{Side::Left}, per_length)};
    const double side = tiling::mean_tile_side(surface.tessellation);  // all are equal, with one node each
    const Conditions conditions = resolve(load_case, surface);
    EXPECT_LT((total_force(conditions) - 3.0 * std::sqrt(3.0) * side * per_length).norm(), 1e-12);
    EXPECT_EQ(conditions.loads.size(), 6U);
}

// A rectangle's corners and a strip's other long side lie near to a side, too, but do not face it.
TEST(LineLoad, OnASideDoesNotDependOnTheTiles) {
    for (const double height : {0.1, 0.02}) {
        const outlines::Outline outline =
            outlines::make_outline({{0, 0}, {0.2, 0}, {0.2, height}, {0, height}}, {});
        for (const double edge : {0.02, 0.011}) {
            const Surface surface = make_surface(
                make_project(outline, {.edge_length = edge, .painting = PaintOnePattern{"0-1+1-6"}}, nullptr)
                    .project,
                nullptr);
            LoadCase load_case;
            load_case.name = "rail";
            for (const Side side : {Side::Left, Side::Right, Side::Bottom, Side::Top}) {
                load_case.loads = {line_load(NodesAtSide{side}, {0, 0, -3})};
                const double length = side == Side::Left || side == Side::Right ? height : 0.2;
                EXPECT_NEAR(total_force(resolve(load_case, surface)).z(), -3 * length, 1e-9) << edge;
            }
        }
    }
}

TEST(LineLoad, BetweenTwoPointsRunsTheShorterWayAlongTheRim) {
    const Surface surface = make_surface(test::honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    const auto& vertices = surface.tessellation.vertices;
    const tiling::Tile& corner = surface.tessellation.tiles.front();  // its first side faces down
    const geometry::Point2 a = vertices[corner.vertices[0]];
    const geometry::Point2 b = vertices[corner.vertices[1]];
    const geometry::Point2 middle{(a.x + b.x) / 2, (a.y + b.y) / 2 - 0.01};
    LoadCase load_case;
    load_case.name = "rail";
    for (const auto& ends : {std::array{a, b}, std::array{b, a}}) {
        load_case.loads = {line_load(NodesNearest{{ends[0], ends[1]}}, {0, 0, -3})};
        const Conditions conditions = resolve(load_case, surface);
        ASSERT_EQ(conditions.loads.size(), 1U);
        EXPECT_EQ(conditions.loads.front().node.value, corner.interface_nodes[0].value);
        EXPECT_NEAR(total_force(conditions).z(), -3 * (b.x - a.x), 1e-12);
    }
    load_case.loads = {line_load(NodesNearest{{a, middle}}, {0, 0, -3})};
    EXPECT_NEAR(total_force(resolve(load_case, surface)).z(), -1.5 * (b.x - a.x), 1e-12) << "half of a side";
    load_case.loads = {line_load(NodesNearest{{a, a}}, {0, 0, -3})};
    EXPECT_THAT(complaint_of([&] { (void)resolve(load_case, surface); }),
                AllOf(HasSubstr("/loads/0"), HasSubstr("one place")));
}

TEST(EntryMarks, SayOfEachLoadWhatTheSolverPutsOnItsNodes) {
    const Surface surface = make_surface(test::honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    LoadCase load_case;
    load_case.name = "all kinds";
    load_case.loads = {{NodesAtSide{Side::Right}, {0, 0, 3}, {1, 0, 0}, LoadCase::Amount::Each},
                       {NodesAtSide{Side::Right}, {0, 2, 3}, {0, 0, 4}, LoadCase::Amount::Total},
                       line_load(NodesAtSide{Side::Left}, {0.5, 0, -2})};
    load_case.area_loads = {{Selection(NodesAtSide{Side::Left}), {0, 0, -5}},
                            {LoadCase::AreaLoad::Tiles{{0, 5}}, {1, 0, 7}}};
    const EntryMarks marks = entry_marks(load_case, surface.tessellation);
    ASSERT_EQ(marks.loads.size(), 5U);
    const std::size_t nodes = surface.tessellation.interface_nodes.size();
    mechanics::NodeValues marked =
        mechanics::NodeValues::Zero(static_cast<Eigen::Index>(nodes), mechanics::kDofsPerNode);
    for (const EntryMarks::Load& load : marks.loads) {
        ASSERT_EQ(load.nodes.size(), load.shares.size());
        for (std::size_t i = 0; i < load.nodes.size(); ++i) {
            marked.row(load.nodes[i].value).head<3>() += load.shares[i] * load.force;
            marked.row(load.nodes[i].value).tail<3>() += load.shares[i] * load.moment;
        }
    }
    // Equal but for the order of sums.
    EXPECT_LT((marked - load_rows(resolve(load_case, surface), nodes)).norm(), 1e-12);
    EXPECT_EQ(marks.loads[1].extent, 0.0);
    EXPECT_NEAR(marks.loads[2].force.z(), -2 * marks.loads[2].extent, 1e-12);
}

TEST(LineLoad, IsKeptByFilesOfTheThirdFormat) {
    const std::string text = R"({"format": "fretwork/load-case/3", "name": "rail",
        "loads": [{"side": "top", "per_length": [0, 0, -1]}, {"between": [[0, 0], [1, 0]], "per_length": [0, 2, 0]}]})";
    const LoadCase load_case = parse_load_case(text, "rail.json");
    ASSERT_EQ(load_case.loads.size(), 2U);
    EXPECT_EQ(load_case_text(parse_load_case(load_case_text(load_case), "again")), load_case_text(load_case));
    std::string second = text;
    second.replace(second.find("case/3"), 6, "case/2");
    EXPECT_THAT(complaint_of([&] { (void)parse_load_case(second, "rail.json"); }), HasSubstr("per_length"));
    std::string both = text;
    both.replace(both.find("\"side\""), 0, "\"between\": [[0, 0], [1, 0]], ");
    EXPECT_THAT(complaint_of([&] { (void)parse_load_case(both, "rail.json"); }),
                HasSubstr("one of side, between"));
}

// ---- messages and marks ----

TEST(LoadCaseText, TellsHowManyNodesEachEntryPicked) {
    const Surface surface = make_surface(test::honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    const auto count = select_nodes(NodesAtSide{Side::Left}, surface.tessellation).size();
    const auto lines = entry_texts(test::cantilever({0, 0, 1}), surface.tessellation);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_THAT(lines[0], AllOf(HasSubstr("left: " + std::to_string(count) + " nodes"), HasSubstr("uz")));
    EXPECT_THAT(lines[1], HasSubstr("right: "));
}

TEST(LoadCaseText, DoubtsWhatIsAThousandTimesOff) {
    const Surface surface = make_surface(test::honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    LoadCase load_case = test::cantilever({0, 0, 0.1});
    EXPECT_TRUE(warnings_about(load_case, surface).empty());
    load_case.loads.push_back({NodesNearest{{{280, 190}}}, {0, 0, 0.1}});
    load_case.prescribed = {{NodesById{{4}}, mechanics::Dof::uz, 2.0},
                            {NodesById{{5}}, mechanics::Dof::rx, 15.0}};
    load_case.gravity = {0, 0, -9810};
    const auto doubts = warnings_about(load_case, surface);
    ASSERT_EQ(doubts.size(), 4U);
    EXPECT_THAT(doubts[0], HasSubstr("(280, 190)"));
    EXPECT_THAT(doubts[1], HasSubstr("metres"));
    EXPECT_THAT(doubts[2], HasSubstr("radians"));
    EXPECT_THAT(doubts[3], HasSubstr("gravity"));
    EXPECT_THAT(warnings_about(test::cantilever({0, 0, 1000}), surface).front(), HasSubstr("newtons"));
}

// ---- combinations ----

std::vector<LoadCase> wind_and_snow() {
    LoadCase snow = test::cantilever({0, 0, -2});
    snow.name = "snow";
    snow.area_loads = {{Selection(kEverywhere), {0, 0, -10}}};
    snow.gravity = {0, 0, -9.81};
    LoadCase wind = test::cantilever({3, 0, 0});
    wind.name = "wind";
    wind.prescribed = {{NodesById{{4}}, mechanics::Dof::uz, 0.001}};
    return {snow, wind};
}

TEST(Combination, HasTheLoadsOfItsCasesTimesTheirFactors) {
    LoadCase both;
    both.name = "both";
    both.combines = {{"snow", 1.5}, {"wind", -0.5}};
    const LoadCase sum = combined(both, wind_and_snow());
    EXPECT_TRUE(sum.combines.empty());
    EXPECT_EQ(sum.supports.size(), 2U);
    EXPECT_EQ(sum.loads[0].force, Eigen::Vector3d(0, 0, -3));
    EXPECT_EQ(sum.loads[1].force, Eigen::Vector3d(-1.5, 0, 0));
    EXPECT_EQ(sum.area_loads[0].per_area, Eigen::Vector3d(0, 0, -15));
    EXPECT_EQ(sum.prescribed[0].value, -0.0005);
    EXPECT_NEAR(sum.gravity.z(), -1.5 * 9.81, 1e-12);
}

TEST(Combination, AddsTheFactorsOfACaseThatIsNamedTwice) {
    LoadCase once;
    once.name = "both";
    LoadCase twice = once;
    once.combines = {{"snow", 1.5}, {"wind", -0.5}};
    twice.combines = {{"snow", 1.0}, {"wind", -0.5}, {"snow", 0.5}};
    LoadCase sum = combined(twice, wind_and_snow());
    EXPECT_EQ(sum.loads.size(), combined(once, wind_and_snow()).loads.size());
    EXPECT_EQ(sum, combined(once, wind_and_snow()));
}

/// The loads are there once, and not as often as the case is named.
TEST(Combination, NamesACaseManyThousandTimes) {
    constexpr std::size_t kLoads = 500;
    constexpr int kTimes = 4000;
    LoadCase many;
    many.name = "many";
    many.loads.assign(kLoads, {NodesAtSide{Side::Left}, {0, 0, -2}});
    LoadCase often;
    often.name = "often";
    often.combines.assign(kTimes, {"many", 0.25});
    std::vector<LoadCase> cases = {many, often};
    check_combinations(cases);
    const LoadCase sum = combined(often, cases);
    ASSERT_EQ(sum.loads.size(), kLoads);
    EXPECT_EQ(sum.loads.back().force, Eigen::Vector3d(0, 0, -2 * 0.25 * kTimes));
    cases[1].combines.push_back({"mny", 1.0});
    EXPECT_THAT(complaint_of([&] { check_combinations(cases); }),
                AllOf(HasSubstr("load case 'often'"), HasSubstr("/combines/4000/load_case"),
                      HasSubstr("did you mean 'many'?")));
}

TEST(Combination, NamesTheCaseThatThereIsNot) {
    LoadCase both;
    both.name = "both";
    both.combines = {{"snow", 1.0}, {"wnd", 1.0}};
    EXPECT_THAT(complaint_of([&] { (void)combined(both, wind_and_snow()); }),
                AllOf(HasSubstr("/combines/1/load_case"), HasSubstr("wind")));
    both.combines = {{"both", 1.0}};
    EXPECT_THAT(complaint_of([&] { (void)combined(both, wind_and_snow()); }), HasSubstr("itself"));
    std::vector<LoadCase> cases = wind_and_snow();
    cases[1].combines = {{"snow", 1.0}};
    both.combines = {{"wind", 1.0}};
    EXPECT_THAT(complaint_of([&] { (void)combined(both, cases); }), HasSubstr("combination, too"));
    EXPECT_THAT(
        complaint_of([&] { (void)resolve(both, make_surface(test::honeycomb(2, 2, {"0-6"}), nullptr)); }),
        HasSubstr("looked for in a project"));
}

TEST(LoadCaseFile, KeepsAreaLoadsAndCombinations) {
    const std::string text = R"({"format": "fretwork/load-case/2", "name": "all",
        "loads": [{"box": [0, 0, 1, 1], "per_area": [0, 0, -1]}, {"nodes": [1], "force": [1, 0, 0]},
                  {"tiles": [1, 3], "per_area": [0, 0, -2]}],
        "combines": [{"load_case": "snow", "factor": 1.5}]})";
    const LoadCase load_case = parse_load_case(text, "all.json");
    ASSERT_EQ(load_case.loads.size(), 1U);
    ASSERT_EQ(load_case.area_loads.size(), 2U);
    EXPECT_EQ(std::get<LoadCase::AreaLoad::Tiles>(load_case.area_loads[1].where).numbers,
              (std::vector<int>{1, 3}));
    EXPECT_EQ(load_case.combines[0].factor, 1.5);
    EXPECT_EQ(load_case_text(parse_load_case(load_case_text(load_case), "again")), load_case_text(load_case));
    std::string first = text;
    first.replace(first.find("case/2"), 6, "case/1");
    EXPECT_THAT(complaint_of([&] { (void)parse_load_case(first, "all.json"); }), HasSubstr("per_area"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
