// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"
#include "stops.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>
#include <fretwork/reduction/response.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace fretwork::reduction {
namespace THIS_TEST {

constexpr const char* kPattern = "0-1+1-6";

Setting with_magnitudes_times(double factor) {
    Setting setting = paper_setting();
    for (Scenario& scenario : setting.scenarios) scenario.max_magnitude *= factor;
    return setting;
}

TEST(PatternFrame, HasTheInterfaceNodesOfTheReferenceHexagonFirst) {
    const auto frame = pattern_frame(paper_layout(), paper_pattern(kPattern), paper_setting());
    for (int i = 0; i < 6; ++i) {
        const double angle = (270.0 + 60.0 * i) * std::numbers::pi / 180.0;
        const Eigen::Vector3d expected(0.0225 * std::cos(angle), 0.0225 * std::sin(angle), 0.0);
        EXPECT_LT((frame.nodes[i] - expected).norm(), 1e-15);
    }
    EXPECT_EQ(frame.beams.size(), 12U) << "two edges, six sectors";
}

TEST(Responses, UnderSmallLoadsAreThoseOfTheLinearModel) {
    const Setting setting = with_magnitudes_times(1e-6);
    const auto pattern = paper_pattern(kPattern);
    const auto responses = compute_responses(paper_layout(), pattern, setting);
    const auto tile = pattern_frame(paper_layout(), pattern, setting);
    ASSERT_EQ(responses.size(), 5U);
    for (std::size_t s = 0; s < 5; ++s) {
        const auto linear =
            mechanics::solve_linear(mechanics::assemble(scenario_frame(tile, setting.scenarios[s])));
        for (const auto& sample : responses[s].samples) {
            EXPECT_TRUE(sample.converged);
            const mechanics::NodeValues expected = sample.step / 10.0 * linear.displacements.topRows(6);
            // The rest is the nonlinear part, of second order: about 1e-6 of the displacements.
            EXPECT_LT(relative_difference(sample.displacements, expected), 1e-5) << responses[s].scenario;
        }
    }
}

TEST(Responses, StopAtAnyLook) {
    const Setting setting = paper_setting();
    const auto pattern = paper_pattern(kPattern);
    test::expect_stops_at_any_look(
        [&](const base::Control& control) {
            (void)compute_responses(paper_layout(), pattern, setting,
                                    {.estimate_error = true, .control = control});
        },
        [] {});
    const ModelTile tile(find_tile_model("full"), paper_layout(), pattern, setting);
    test::expect_stops_at_any_look([&](const base::Control& control) { (void)tile.responses({}, control); },
                                   [] {});
}

TEST(Responses, HaveTenMagnitudesInEvenStepsUpToTheLargest) {
    const Setting setting = paper_setting();
    const auto responses = compute_responses(paper_layout(), paper_pattern(kPattern), setting);
    for (std::size_t s = 0; s < 5; ++s) {
        ASSERT_EQ(responses[s].samples.size(), 10U);
        EXPECT_EQ(responses[s].scenario, setting.scenarios[s].name);
        EXPECT_EQ(responses[s].samples.back().magnitude, setting.scenarios[s].max_magnitude);
        EXPECT_DOUBLE_EQ(responses[s].samples[3].magnitude, 0.4 * setting.scenarios[s].max_magnitude);
    }
}

TEST(Responses, EstimateTheirDiscretizationErrorForAnyDivisions) {
    Setting setting = paper_setting();
    const auto pattern = paper_pattern(kPattern);
    setting.divisions = 16;
    const auto exact = compute_responses(paper_layout(), pattern, setting);
    for (const int divisions : {1, 2}) {
        setting.divisions = divisions;
        const auto responses = compute_responses(paper_layout(), pattern, setting, {.estimate_error = true});
        for (std::size_t s = 0; s < 5; ++s) {
            const auto& sample = responses[s].samples.back();
            const mechanics::NodeValues& finest = exact[s].samples.back().displacements;
            const auto difference = (sample.displacements - finest).leftCols<3>();
            const double share =
                difference.rowwise().norm().maxCoeff() / finest.leftCols<3>().rowwise().norm().maxCoeff();
            ASSERT_TRUE(sample.discretization_error.has_value());
            // Errors of one element a beam can cancel; nodes within the tile and rotations, which count in
            // the estimate, can be off by more; and the order may be four where the estimate takes two.
            EXPECT_LE(share, 1.5 * *sample.discretization_error)
                << responses[s].scenario << ", " << divisions;
            EXPECT_GE(share, *sample.discretization_error / 20.0)
                << responses[s].scenario << ", " << divisions;
            EXPECT_LT(share, divisions == 1 ? 2e-3 : 3e-4) << responses[s].scenario;
        }
    }
}

TEST(Responses, KeepHeldComponentsAtZero) {
    const Setting setting = paper_setting();
    const auto responses = compute_responses(paper_layout(), paper_pattern(kPattern), setting);
    for (std::size_t s = 0; s < 5; ++s) {
        for (const auto& support : setting.scenarios[s].supports) {
            for (int dof = 0; dof < 6; ++dof) {
                if (!support.fixed.contains[static_cast<std::size_t>(dof)]) continue;
                for (const auto& sample : responses[s].samples) {
                    EXPECT_NEAR(sample.displacements(support.interface_node, dof), 0.0, 1e-12);
                }
            }
        }
    }
}

TEST(Responses, AreUnstableFromTheBucklingLoadOn) {
    Setting setting = paper_setting();
    setting.scenarios.resize(1);
    const auto responses = compute_responses(paper_layout(), paper_pattern(kPattern), setting);
    std::vector<bool> stable;
    for (const auto& sample : responses[0].samples) {
        EXPECT_TRUE(sample.converged);
        stable.push_back(sample.stable);
        // The state that buckles is the flat one, which is kept.
        EXPECT_EQ(sample.displacements.col(2).cwiseAbs().maxCoeff(), 0.0);
    }
    // In the plane, pushed by up to 2 N: once it is lost, stability does not come back.
    EXPECT_TRUE(stable.front());
    EXPECT_FALSE(stable.back());
    EXPECT_TRUE(std::is_sorted(stable.rbegin(), stable.rend()));
}

/// Turn everything that a scenario says by 60 degrees: to the next interface node, and around z.
Scenario turned(const Scenario& scenario) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(std::numbers::pi / 3.0, Eigen::Vector3d::UnitZ()).matrix();
    Scenario result = scenario;
    for (auto& support : result.supports) support.interface_node = (support.interface_node + 1) % 6;
    for (auto& load : result.loads) {
        load.interface_node = (load.interface_node + 1) % 6;
        Eigen::Map<Eigen::Vector3d> force(load.force.data());
        Eigen::Map<Eigen::Vector3d> moment(load.moment.data());
        force = (turn * force).eval();
        moment = (turn * moment).eval();
    }
    return result;
}

TEST(Responses, RotateWithAScenarioThatIsRotatedBy60Degrees) {
    Setting setting = paper_setting();
    setting.scenarios = {paper_scenarios()[2], turned(paper_scenarios()[2])};
    setting.scenarios[1].name = "turned";
    const auto responses = compute_responses(paper_layout(), paper_pattern(kPattern), setting);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(std::numbers::pi / 3.0, Eigen::Vector3d::UnitZ()).matrix();
    const auto& first = responses[0].samples.back().displacements;
    const auto& second = responses[1].samples.back().displacements;
    for (int node = 0; node < 6; ++node) {
        const Eigen::Vector3d translation = turn * first.row(node).head<3>().transpose();
        const Eigen::Vector3d rotation = turn * first.row(node).tail<3>().transpose();
        // The relative residual of the solutions is 1e-9.
        EXPECT_LT((second.row((node + 1) % 6).head<3>().transpose() - translation).norm(),
                  1e-6 * first.norm());
        EXPECT_LT((second.row((node + 1) % 6).tail<3>().transpose() - rotation).norm(), 1e-6 * first.norm());
    }
}

TEST(Responses, RefuseAPatternThatLeavesInterfaceNodesFree) {
    EXPECT_THROW((void)compute_responses(paper_layout(), paper_pattern("0-1"), paper_setting()),
                 base::InputError);
}

TEST(ApplyScenario, KeepsMomentsThatAreThereAlready) {
    const Setting setting = paper_setting();
    auto tile = mechanics::assemble(pattern_frame(paper_layout(), paper_pattern(kPattern), setting));
    EXPECT_FALSE(tile.has_moments);
    apply_scenario(setting.scenarios[3], tile);
    EXPECT_TRUE(tile.has_moments) << "dome has moments";
    apply_scenario(setting.scenarios[1], tile);
    EXPECT_TRUE(tile.has_moments) << "shear has none";
}

TEST(Responses, RefuseASettingWithoutScenarios) {
    Setting setting = paper_setting();
    setting.scenarios.clear();
    EXPECT_THROW((void)compute_responses(paper_layout(), paper_pattern(kPattern), setting), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
