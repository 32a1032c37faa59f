// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "support.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/load_cases/load_case_text.hpp>

#include <limits>
#include <random>

namespace fretwork::simulation {
namespace THIS_TEST {

using test::complaint_of;
using test::honeycomb;
using testing::AllOf;
using testing::HasSubstr;

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
                    HasSubstr("which has no circle; fretwork/load-case/4 has"))
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

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
