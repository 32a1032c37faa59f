// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/reduction/calibration.hpp>
#include <fretwork/reduction/setting_file.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace fretwork::reduction {
namespace {

/// Targets that the model itself made: its parameters must be found again.
TEST(Calibration, RecoversTheParametersOfASyntheticTarget) {
    const Setting setting = paper_setting();
    const Paper6Hexagon model(setting);
    optimization::RandomStream random(1, 0);
    for (int trial = 0; trial < 6; ++trial) {
        const Paper6Parameters truth = random_parameters(setting, random, 0.42, 0.58);
        const auto responses = linear_responses(model.displacements(truth), setting);
        const Calibration found = calibrate_paper6(responses, setting);
        EXPECT_LT(found.objective, 1e-4) << "trial " << trial;
        EXPECT_NEAR(paper6_parameters(found).theta, truth.theta, 1e-2);
        EXPECT_NEAR(paper6_parameters(found).R, truth.R, 1e-2 * truth.R);
        EXPECT_NEAR(paper6_parameters(found).I2, truth.I2, 2e-2 * truth.I2);
    }
}

TEST(Calibration, IsDeterministicAndItsScenarioErrorsSumToTheObjective) {
    const Setting setting = paper_setting();
    const auto responses = compute_responses(paper_layout(), paper_pattern("0-1+1-6"), setting);
    const Calibration first = calibrate_paper6(responses, setting);
    const Calibration again = calibrate_paper6(responses, setting);
    EXPECT_EQ(first.objective, again.objective);
    EXPECT_EQ(paper6_parameters(first).A, paper6_parameters(again).A);
    EXPECT_EQ(first.evaluations, again.evaluations);
    ASSERT_EQ(first.scenario_errors.size(), 5U);
    EXPECT_NEAR(std::accumulate(first.scenario_errors.begin(), first.scenario_errors.end(), 0.0),
                first.objective, 1e-12 * first.objective);
    EXPECT_TRUE(first.converged);
    const Objective objective(responses, setting);
    EXPECT_EQ(objective.value(Paper6Hexagon(setting).displacements(paper6_parameters(first))),
              first.objective);
}

TEST(Calibration, MoreStartsAreNotWorse) {
    const Setting setting = paper_setting();
    const auto responses = compute_responses(paper_layout(), paper_pattern("1-6+3-6"), setting);
    const double few = calibrate_paper6(responses, setting, {.starts = 4}).objective;
    const double many = calibrate_paper6(responses, setting, {.starts = 40}).objective;
    EXPECT_LE(many, few * (1.0 + 1e-6));
    EXPECT_LE(few, many * 1.01);
}

/// Displacements depend on loads over stiffness only, and so does the objective.
TEST(Calibration, AnotherMaterialUnderLoadsInProportionGivesTheSameObjective) {
    const Setting paper = paper_setting();
    const Setting pla = read_setting(FRETWORK_SOURCE_DIR "/experiments/settings/pla.json");
    ASSERT_NE(pla.material.young_modulus, paper.material.young_modulus);
    for (const char* id : {"0-1+1-6", "1-3+3-6"}) {
        const auto objective = [&](const Setting& setting) {
            const auto responses = compute_responses(paper_layout(), paper_pattern(id), setting);
            return calibrate_paper6(responses, setting).objective;
        };
        EXPECT_NEAR(objective(pla), objective(paper), 1e-5 * objective(paper)) << id;
    }
}

TEST(Calibration, NamesParametersAtABound) {
    // A target far stiffer along its beams than the model may be: A ends at its upper bound.
    const Setting setting = paper_setting();
    Paper6Parameters truth{0, setting.section.I2, setting.section.I3, setting.section.J, 0.2, 0.012};
    truth.A = 1e6 * setting.section.area;
    Setting softer = setting;
    softer.section.area = 1e-3 * setting.section.area;
    const auto responses = linear_responses(Paper6Hexagon(setting).displacements(truth), setting);
    const Calibration found = calibrate_paper6(responses, softer);
    EXPECT_NE(std::ranges::find(found.at_bound, "A"), found.at_bound.end());
}

TEST(Calibration, StaysWithinItsBudget) {
    const Setting setting = paper_setting();
    const auto responses = compute_responses(paper_layout(), paper_pattern("0-1+1-6"), setting);
    const Calibration found = calibrate_paper6(responses, setting, {.budget = 30});
    EXPECT_EQ(found.evaluations, 30);
    EXPECT_FALSE(found.converged);
}

TEST(Calibration, RefusesBadOptionsAndResponsesWithoutAUsableSample) {
    const Setting setting = paper_setting();
    auto responses = linear_responses(UnitDisplacements(5, mechanics::NodeValues::Ones(6, 6)), setting);
    EXPECT_THROW((void)calibrate_paper6(responses, setting, {.optimizer = "ceres"}), base::InputError);
    EXPECT_THROW((void)calibrate_paper6(responses, setting, {.starts = 0}), base::InputError);
    EXPECT_THROW((void)calibrate_paper6(responses, setting, {.budget = 0}), base::InputError);
    for (auto& response : responses) {
        for (auto& sample : response.samples) sample.converged = false;
    }
    EXPECT_THROW((void)calibrate_paper6(responses, setting), base::NumericalError);
}

}  // namespace
}  // namespace fretwork::reduction
