// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/load_cases/load_case_text.hpp>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

namespace fretwork::simulation {
namespace THIS_TEST {

using test::complaint_of;
using test::honeycomb;
using testing::AllOf;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A load case of a file with these entries.
LoadCase read(const std::string& entries, int format = 4) {
    return parse_load_case(
        R"({"format": "fretwork/load-case/)" + std::to_string(format) + R"(", "name": "x", )" + entries + "}",
        "case.json");
}

TEST(NodesInCircle, AreThoseWhoseSquaredDistanceIsAtMostTheSquaredRadius) {
    const tiling::Tessellation tessellation = honeycomb(5, 4, {"0-1+1-6"}).tessellation;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0.0, 0.2);
    std::uniform_real_distribution<double> size(0.03, 0.15);
    for (int trial = 0; trial < 50; ++trial) {
        const NodesInCircle circle{{place(random), place(random)}, size(random)};
        std::vector<tiling::InterfaceIndex> expected;
        for (std::size_t i = 0; i < tessellation.interface_nodes.size(); ++i) {
            const double dx = tessellation.interface_nodes[i].x - circle.center.x;
            const double dy = tessellation.interface_nodes[i].y - circle.center.y;
            if (dx * dx + dy * dy <= circle.radius * circle.radius) expected.emplace_back(i);
        }
        if (expected.empty()) continue;
        EXPECT_EQ(select_nodes(circle, tessellation), expected) << trial;
    }
}

TEST(NodesInCircle, IncludeThoseOnItsLine) {
    tiling::Tessellation tessellation = honeycomb(2, 1, {"0-1+1-6"}).tessellation;
    for (auto& node : tessellation.interface_nodes) node = {9, 9};
    tessellation.interface_nodes[tiling::InterfaceIndex(2)] = {3, 4};
    const std::vector<tiling::InterfaceIndex> third{tiling::InterfaceIndex(2)};
    EXPECT_EQ(select_nodes(NodesInCircle{{0, 0}, 5}, tessellation), third);
    EXPECT_THAT(complaint_of([&] {
                    (void)select_nodes(NodesInCircle{{0, 0}, 4.999}, tessellation);
                }),
                HasSubstr("no interface node"));
}

TEST(NodesInCircle, AreRefusedInALineWithoutAPositiveRadiusOrWithoutANode) {
    const Surface surface = make_surface(honeycomb(2, 1, {"0-1+1-6"}), nullptr);
    for (const double radius : {0.0, -0.01, kNone, std::numeric_limits<double>::infinity()}) {
        const std::string complaint = complaint_of([&] {
            (void)select_nodes(NodesInCircle{{0, 0}, radius}, surface.tessellation);
        });
        EXPECT_THAT(complaint, HasSubstr("a length above 0 m is needed")) << radius;
        EXPECT_EQ(complaint.find('\n'), std::string::npos);
    }
    LoadCase load_case = test::cantilever({0, 0, 1});
    load_case.supports.push_back({NodesInCircle{{9, 8}, 0.5}, mechanics::DofSet::all()});
    EXPECT_THAT(complaint_of([&] { check_selections(load_case, surface.tessellation); }),
                AllOf(HasSubstr("load case 'cantilever'"), HasSubstr("/supports/1"),
                      HasSubstr("no interface node lies in the circle of radius 0.5 m around (9, 8)")));
}

/// A row of three tiles of size 1 x `height`, of which `lift(x)` lifts the vertices. Interface nodes: those
/// of the lower sides, of the upper sides, and of the four sides across, each from left to right.
tiling::Tessellation row_of_three(double height, double (*lift)(double)) {
    tiling::Tessellation row;
    row.layout = "paper7";
    const auto add_middle = [&](int a, int b) {
        const geometry::Point2 from = row.vertices[tiling::VertexIndex(a)];
        const geometry::Point2 to = row.vertices[tiling::VertexIndex(b)];
        row.interface_nodes.push_back({(from.x + to.x) / 2, (from.y + to.y) / 2});
    };
    for (const double low : {0.0, height})
        for (const double x : {0.0, 1.0, 2.0, 3.0}) row.vertices.push_back({x, low + lift(x)});
    for (const int first : {0, 4})
        for (int i = 0; i < 3; ++i) add_middle(first + i, first + i + 1);
    for (int i = 0; i < 4; ++i) add_middle(i, i + 4);
    for (int i = 0; i < 3; ++i) {
        tiling::Tile tile;
        for (const int vertex : {i, i + 1, i + 5, i + 4}) tile.vertices.emplace_back(vertex);
        for (const int node : {i, 7 + i, 3 + i, 6 + i}) tile.interface_nodes.emplace_back(node);
        row.tiles.push_back(tile);
    }
    return row;
}

double no_lift(double) {
    return 0.0;
}

std::vector<int> at_side(Side side, const tiling::Tessellation& tessellation) {
    std::vector<int> numbers;
    for (const auto node : select_nodes(NodesAtSide{side}, tessellation)) numbers.push_back(node.value);
    return numbers;
}

// Both long sides of a row of tiles lie within one tile side of each other.
TEST(NodesAtSide, OfANarrowRowLieOnTheLineThatFacesTheSideAndOnTheEnds) {
    const tiling::Tessellation flat = row_of_three(1.0, no_lift);
    EXPECT_THAT(at_side(Side::Bottom, flat), ElementsAre(0, 1, 2, 6, 9));
    EXPECT_THAT(at_side(Side::Top, flat), ElementsAre(3, 4, 5, 6, 9));
    EXPECT_THAT(at_side(Side::Left, flat), ElementsAre(0, 3, 6));
    EXPECT_THAT(at_side(Side::Right, flat), ElementsAre(2, 5, 9));
    // Also where the row rises so much that parts of its lower line lie above parts of the upper one.
    const tiling::Tessellation rising = row_of_three(0.5, [](double x) { return 0.19 * x; });
    EXPECT_THAT(at_side(Side::Bottom, rising), ElementsAre(0, 1, 2, 6, 9));
    EXPECT_THAT(at_side(Side::Top, rising), ElementsAre(3, 4, 5, 6, 9));
    tiling::Tessellation upright = flat;  // turned by a quarter
    for (auto& place : upright.vertices) place = {-place.y, place.x};
    for (auto& place : upright.interface_nodes) place = {-place.y, place.x};
    EXPECT_THAT(at_side(Side::Right, upright), ElementsAre(0, 1, 2, 6, 9));
    EXPECT_THAT(at_side(Side::Left, upright), ElementsAre(3, 4, 5, 6, 9));
}

TEST(NodesAtSide, OfAWideSurfaceAreAllRimNodesWithinOneTileSide) {
    const tiling::Tessellation tessellation = honeycomb(4, 3, {"0-1+1-6"}).tessellation;
    const double side = tiling::mean_tile_side(tessellation);
    double low = std::numeric_limits<double>::infinity();
    for (const auto& node : tessellation.interface_nodes) low = std::min(low, node.x);
    std::set<int> expected;
    for (const auto& loop : tiling::rim_loops(tessellation))
        for (const auto node : loop)
            if (tessellation.interface_nodes[node].x <= low + side) expected.insert(node.value);
    EXPECT_THAT(at_side(Side::Left, tessellation), ElementsAreArray(expected));
}

// The left end of the upper line is nearer to the bottom, but the upper side of the first tile faces up.
TEST(LineLoad, OnARisingRowActsOnItsWholeUpperLine) {
    Surface surface = make_surface(honeycomb(2, 1, {"0-1+1-6"}), nullptr);
    surface.tessellation = row_of_three(0.2, [](double x) { return 0.16 * x; });
    LoadCase load_case;
    load_case.name = "rail";
    load_case.loads = {
        {NodesAtSide{Side::Top}, {0, 0, -2}, Eigen::Vector3d::Zero(), LoadCase::Amount::PerLength}};
    double force = 0.0;
    for (const auto& load : resolve(load_case, surface).loads) force += load.force.z();
    EXPECT_NEAR(force, -2 * 3.0, 1e-12);
}

TEST(LineLoad, BetweenPointsThatAreNoPlacesIsRefused) {
    const Surface surface = make_surface(honeycomb(2, 1, {"0-1+1-6"}), nullptr);
    for (const double bad : {kNone, std::numeric_limits<double>::infinity(), 1e300}) {
        LoadCase load_case;
        load_case.name = "rail";
        load_case.loads = {{NodesNearest{{{0, 0}, {bad, 0.5}}},
                            {0, 0, -2},
                            Eigen::Vector3d::Zero(),
                            LoadCase::Amount::PerLength}};
        EXPECT_THAT(
            complaint_of([&] { (void)resolve(load_case, surface); }),
            AllOf(HasSubstr("load case 'rail': /loads/0: point 1 is (" + base::format_number(bad) + ", 0.5)"),
                  HasSubstr("a number from -1e+12 to 1e+12 (m)")));
    }
}

TEST(NodesNearest, ToAPointThatIsNoPlaceAreRefused) {
    const tiling::Tessellation tessellation = honeycomb(2, 1, {"0-1+1-6"}).tessellation;
    for (const double bad : {kNone, std::numeric_limits<double>::infinity(), 1e300}) {
        EXPECT_THAT(complaint_of([&] {
                        (void)select_nodes(NodesNearest{{{0, 0}, {bad, 0.5}}}, tessellation);
                    }),
                    AllOf(HasSubstr("point 1 is (" + base::format_number(bad) + ", 0.5)"),
                          HasSubstr("a number from -1e+12 to 1e+12 (m)")));
    }
}

TEST(LoadCaseFile, KeepsCirclesInItsFourthFormat) {
    const std::string entries = R"(
        "supports": [{"circle": {"center": [0.1, 0.2], "radius": 0.05}, "fixed": ["uz"]}],
        "loads": [{"circle": {"center": [0, 0], "radius": 1}, "force": [0, 0, 1], "amount": "total"},
                  {"circle": {"center": [0, 0], "radius": 2}, "per_area": [0, 0, -1]}],
        "prescribed": [{"circle": {"center": [0, 0], "radius": 3}, "uz": 0.01}])";
    const LoadCase load_case = read(entries);
    EXPECT_EQ(load_case.supports[0].where, Selection(NodesInCircle{{0.1, 0.2}, 0.05}));
    EXPECT_EQ(load_case.loads[0].where, Selection(NodesInCircle{{0, 0}, 1}));
    EXPECT_EQ(load_case.area_loads[0].where,
              (std::variant<Selection, LoadCase::AreaLoad::Tiles>(Selection(NodesInCircle{{0, 0}, 2}))));
    EXPECT_EQ(load_case.prescribed[0].where, Selection(NodesInCircle{{0, 0}, 3}));
    const std::string text = load_case_text(load_case);
    EXPECT_THAT(text, HasSubstr("fretwork/load-case/4"));
    EXPECT_EQ(parse_load_case(text, "again"), load_case);
    for (const int format : {1, 2, 3}) {
        EXPECT_THAT(complaint_of([&] {
                        (void)read(
                            R"("supports": [{"circle": {"center": [0, 0], "radius": 1}, "fixed": []}])",
                            format);
                    }),
                    HasSubstr("/supports/0/circle: fretwork/load-case/" + std::to_string(format) +
                              " has no circle; fretwork/load-case/4 has"))
            << format;
    }
}

TEST(LoadCaseFile, IsOfTheFirstFormatWithoutACircle) {
    EXPECT_THAT(load_case_text(read(R"("supports": [{"side": "left", "fixed": ["uz"]}])")),
                HasSubstr("fretwork/load-case/1"));
}

TEST(LoadCaseFile, RefusesBadCirclesWithTheirPlace) {
    const std::vector<std::pair<std::string, std::string>> faults = {
        {R"({"center": [0, 0], "radius": 0})", "case.json: /supports/0/circle/radius: is 0"},
        {R"({"center": [0, 0], "radius": -1})", "case.json: /supports/0/circle/radius: is -1"},
        {R"({"center": [0, 0], "radius": NaN})", "malformed JSON"},
        {R"({"center": [0, 0], "radius": null})", "case.json: /supports/0/circle/radius: "},
        {R"({"center": [0], "radius": 1})", "case.json: /supports/0/circle/center: has 1 element"},
        {R"({"center": [0, 0]})", "'radius' is missing"},
        {R"({"centre": [0, 0], "radius": 1})", "did you mean 'center'?"},
        {R"([0, 0, 1])", "case.json: /supports/0/circle: "}};
    for (const auto& [circle, complaint] : faults) {
        const std::string said =
            complaint_of([&] { (void)read(R"("supports": [{"fixed": [], "circle": )" + circle + "}]"); });
        EXPECT_THAT(said, HasSubstr(complaint)) << circle;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
    EXPECT_THAT(
        complaint_of([] {
            (void)read(
                R"("loads": [{"side": "left", "circle": {"center": [0, 0], "radius": 1}, "force": [0, 0, 1]}])");
        }),
        HasSubstr("exactly one of nodes, box, circle, nearest, side"));
}

TEST(LoadCaseText, NamesACircleByItsRadiusAndMiddle) {
    const tiling::Tessellation tessellation = honeycomb(3, 2, {"0-1+1-6"}).tessellation;
    LoadCase load_case;
    load_case.name = "x";
    load_case.supports = {{NodesInCircle{{0.02, 0.01}, 0.5}, mechanics::DofSet::all()}};
    EXPECT_THAT(entry_texts(load_case, tessellation).front(),
                AllOf(HasSubstr("circle of radius 500 mm around "),
                      HasSubstr(std::to_string(tessellation.interface_nodes.size()) + " nodes")));
}

// ---- places of entries in messages ----

/// A file has loads of all kinds in one list, and an entry of it may prescribe several components.
TEST(EntryPlace, IsThePositionInTheFile) {
    const Surface surface = make_surface(honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    const auto complaint = [&](const std::string& entries) {
        const LoadCase load_case = read(entries);
        EXPECT_EQ(parse_load_case(load_case_text(load_case), "again"), load_case) << "places do not count";
        return complaint_of([&] { (void)resolve(load_case, surface); });
    };
    const std::string area = R"({"tiles": [0], "per_area": [0, 0, -1]})";
    const std::string no_tile = R"({"tiles": [99], "per_area": [0, 0, -1]})";
    const std::string load = R"({"nodes": [1], "force": [0, 0, 1]})";
    const std::string no_node = R"({"box": [9, 9, 10, 10], "force": [0, 0, 1]})";
    const std::string no_line = R"({"between": [[0, 0], [0, 0]], "per_length": [0, 0, 1]})";
    const auto loads = [&](const std::string& a, const std::string& b, const std::string& c) {
        return complaint(R"("loads": [)" + a + ", " + b + ", " + c + "]");
    };
    EXPECT_THAT(loads(no_tile, load, load), StartsWith("load case 'x': /loads/0/tiles: there is no tile 99"));
    EXPECT_THAT(loads(load, no_tile, load), StartsWith("load case 'x': /loads/1/tiles: there is no tile 99"));
    EXPECT_THAT(loads(area, area, no_node), StartsWith("load case 'x': /loads/2: no interface node"));
    EXPECT_THAT(loads(area, no_line, load), StartsWith("load case 'x': /loads/1: "));
    EXPECT_THAT(complaint(R"("prescribed": [{"nodes": [1], "ux": 0, "uy": 0, "uz": 0.01},
                                            {"nodes": [1], "uz": 0.02}])"),
                StartsWith("load case 'x': /prescribed/1: prescribes 0.02 at interface node 1"));
}

TEST(EntryPlace, StaysWhenOtherEntriesAreRemoved) {
    const Surface surface = make_surface(honeycomb(2, 1, {"0-1+1-6"}), nullptr);
    LoadCase load_case =
        read(R"("supports": [{"nodes": [0], "fixed": ["uz"]}, {"box": [9, 9, 10, 10], "fixed": ["uz"]}])");
    load_case.supports.erase(load_case.supports.begin());
    EXPECT_THAT(complaint_of([&] { check_selections(load_case, surface.tessellation); }),
                StartsWith("load case 'x': /supports/1: no interface node lies in the box"));
}

/// The file of a combination lacks the entries of the combined load cases, so messages name these.
TEST(EntryPlace, OfACombinationIsThatInTheCombinedLoadCase) {
    const Surface surface = make_surface(honeycomb(4, 3, {"0-1+1-6"}), nullptr);
    std::vector<LoadCase> cases = {
        read(R"("loads": [{"tiles": [0], "per_area": [0, 0, -1]}, {"nodes": [1], "force": [0, 0, 1]}],
                "prescribed": [{"nodes": [4], "uz": 0.002}])"),
        test::cantilever({0, 0, 1})};
    LoadCase both;
    both.name = "both";
    both.combines = {{"x", 1.0}, {"cantilever", 1.0}};
    const auto resolved = [&] { return resolve(combined(both, cases), surface); };
    const auto complaint = [&] { return complaint_of(resolved); };
    EXPECT_FALSE(resolved().loads.empty());
    cases[1].area_loads = {{LoadCase::AreaLoad::Tiles{{99}}, {0, 0, -1}}};
    EXPECT_THAT(complaint(),
                StartsWith("load case 'both': load case 'cantilever': /loads/1/tiles: there is"));
    cases[1].prescribed = {{NodesById{{4}}, mechanics::Dof::uz, 0.001}};
    EXPECT_THAT(complaint(),
                StartsWith("load case 'both': load case 'cantilever': /prescribed/0: prescribes 0.001"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
