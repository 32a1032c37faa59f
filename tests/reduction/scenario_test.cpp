// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::reduction {
namespace THIS_TEST {

using testing::HasSubstr;

TEST(PaperScenarios, AreFiveInThePapersOrderWithTheWeightsOfTable2) {
    const auto& scenarios = paper_scenarios();
    ASSERT_EQ(scenarios.size(), 5U);
    const char* names[] = {"axial", "shear", "bending", "dome", "saddle"};
    const double weights[] = {0.5, 0.5, 1.0, 1.0, 1.0};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(scenarios[i].name, names[i]);
        EXPECT_EQ(scenarios[i].weight, weights[i]);
        EXPECT_FALSE(scenarios[i].description.empty());
    }
}

TEST(PaperScenarios, AreTheFilesOfTheExperiments) {
    for (const Scenario& scenario : paper_scenarios()) {
        const std::string path =
            std::string(FRETWORK_SOURCE_DIR) + "/experiments/scenarios/" + scenario.name + ".json";
        EXPECT_EQ(parse_scenario(base::read_text_file(path), path), scenario);
        EXPECT_EQ(parse_scenario(scenario_text(scenario), "its own text"), scenario);
        EXPECT_EQ(read_scenario(path), scenario);
    }
}

/// The moment about the origin of forces and moments on the interface nodes.
Eigen::Matrix<double, 6, 1> resultant(const mechanics::NodeValues& loads, const mechanics::Frame& frame) {
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (Eigen::Index node = 0; node < loads.rows(); ++node) {
        const Eigen::Vector3d force = loads.row(node).head<3>();
        const Eigen::Vector3d moment = loads.row(node).tail<3>();
        sum.head<3>() += force;
        sum.tail<3>() += moment + frame.nodes[node].cross(force);
    }
    return sum;
}

TEST(PaperScenarios, AreInEquilibriumWithTheReactionsOfATile) {
    const Setting setting = paper_setting();
    const auto tile = pattern_frame(paper_layout(), paper_pattern("0-1+1-6"), setting);
    for (const Scenario& scenario : setting.scenarios) {
        const auto assembly = mechanics::assemble(scenario_frame(tile, scenario));
        const auto solution = mechanics::solve_linear(assembly);
        const auto loads = resultant(assembly.loads.topRows(solution.reactions.rows()), tile);
        const auto reactions = resultant(solution.reactions, tile);
        EXPECT_LT((loads + reactions).norm(), 1e-9 * assembly.loads.norm()) << scenario.name;
    }
}

TEST(PaperScenarios, ActInTheDirectionsThatThePaperShows) {
    const Setting setting = paper_setting();
    const auto tile = pattern_frame(paper_layout(), paper_pattern("0-1+1-6"), setting);
    const auto solve = [&](std::size_t s) {
        return mechanics::solve_linear(mechanics::assemble(scenario_frame(tile, setting.scenarios[s])))
            .displacements;
    };
    const Eigen::Vector2d towards_supports(std::cos(5.0 * std::numbers::pi / 3.0),
                                           std::sin(5.0 * std::numbers::pi / 3.0));
    EXPECT_GT(solve(0).row(3).head<2>().dot(towards_supports), 0.0);
    EXPECT_GT(solve(2)(4, 2), 0.0) << "bending lifts the free side";
    // Held on the y axis, a dome sinks on both sides of it, and a saddle rises there.
    EXPECT_LT(solve(3)(1, 2), 0.0);
    EXPECT_GT(solve(4)(1, 2), 0.0);
}

constexpr const char* kValid = R"({ "format": "fretwork/scenario/1", "name": "pull", "weight": 1,
  "max_magnitude": 2, "held": [ { "interface_node": 0, "fixed": ["ux", "rz"] } ],
  "loads": [ { "interface_node": 3, "force": [0, 1, 0] } ] })";

std::string complaint(const std::string& text) {
    try {
        (void)parse_scenario(text, "pull.json");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "no complaint";
}

std::string with(const std::string& old, const std::string& replacement) {
    std::string text = kValid;
    return text.replace(text.find(old), old.size(), replacement);
}

TEST(ScenarioFile, IsReadAsWritten) {
    const Scenario scenario = parse_scenario(kValid, "pull.json");
    EXPECT_EQ(scenario.supports.front().fixed, (mechanics::DofSet{{true, false, false, false, false, true}}));
    EXPECT_EQ(scenario.loads.front().force, (std::array{0.0, 1.0, 0.0}));
    EXPECT_EQ(scenario.loads.front().moment, (std::array{0.0, 0.0, 0.0}));
}

TEST(ScenarioFile, BadInputIsRefusedByItsPlace) {
    EXPECT_THAT(complaint("{"), HasSubstr("pull.json"));
    EXPECT_THAT(complaint(with("fretwork/scenario/1", "fretwork/frame/1")), HasSubstr("/format"));
    EXPECT_THAT(complaint(with("\"weight\": 1", "\"wieght\": 1")), HasSubstr("wieght"));
    EXPECT_THAT(complaint(with("\"weight\": 1", "\"weight\": -1")), HasSubstr("/weight"));
    EXPECT_THAT(complaint(with("\"max_magnitude\": 2", "\"max_magnitude\": 0")), HasSubstr("/max_magnitude"));
    EXPECT_THAT(complaint(with("\"max_magnitude\": 2", "\"max_magnitude\": NaN")), HasSubstr("pull.json"));
    EXPECT_THAT(complaint(with("\"rz\"", "\"rw\"")), HasSubstr("/held/0/fixed/1"));
    EXPECT_THAT(complaint(with("\"rz\"", "\"ux\"")), HasSubstr("/held/0/fixed/1"));
    EXPECT_THAT(complaint(with("[0, 1, 0]", "[0, 1]")), HasSubstr("/loads/0/force"));
    EXPECT_THAT(complaint(with(", \"force\": [0, 1, 0]", "")), HasSubstr("/loads/0"));
    EXPECT_THAT(complaint(with("\"interface_node\": 3", "\"interface_node\": -1")),
                HasSubstr("/loads/0/interface_node"));
    EXPECT_THAT(complaint(with("\"pull\"", "\"\"")), HasSubstr("/name"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
