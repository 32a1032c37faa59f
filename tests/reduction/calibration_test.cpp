// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace fretwork::reduction {
namespace THIS_TEST {

/// Targets that the model itself made: its parameters must be found again.
TEST(Calibration, RecoversTheParametersOfASyntheticTarget) {
    const Setting setting = paper_setting();
    const RingHexagon model(setting);
    base::RandomStream random(1, 0);
    for (int trial = 0; trial < 6; ++trial) {
        const Paper6Parameters truth = random_parameters(setting, random, 0.42, 0.58);
        const auto responses = linear_responses(model.displacements(truth), setting);
        const Calibration found = calibrate_paper6(responses, setting);
        EXPECT_LT(found.objective, 1e-4) << "trial " << trial;
        EXPECT_NEAR(paper6_values(found).theta, truth.theta, 1e-2);
        EXPECT_NEAR(paper6_values(found).R, truth.R, 1e-2 * truth.R);
        EXPECT_NEAR(paper6_values(found).I2, truth.I2, 2e-2 * truth.I2);
    }
}

/// The ten parameters need not be found again: different rings can answer alike. The answers must be.
TEST(Calibration, RecoversTheAnswersOfARingWithSectionsOfItsOwn) {
    const Setting setting = paper_setting();
    const RingHexagon model(setting);
    const pattern::Pattern any = paper_pattern("0-1+1-6");
    base::RandomStream random(2, 0);
    for (int trial = 0; trial < 4; ++trial) {
        RingParts truth = random_parameters(setting, random, 0.42, 0.58);
        truth.segment<4>(4) = random_parameters(setting, random, 0.42, 0.58).parts().head<4>();
        const auto responses = linear_responses(model.displacements(truth), setting);
        const Calibration found =
            calibrate(find_tile_model("ring10"), {paper_layout(), any, setting, responses});
        EXPECT_LT(found.objective, 1e-3) << "trial " << trial;
        EXPECT_GT(calibrate_paper6(responses, setting).objective, 10.0 * found.objective);
    }
}

/// paper6 is ring10 with equal sections, so the best ring10 is no worse.
TEST(Calibration, OfTenParametersIsNoWorseThanOfSix) {
    const Setting setting = paper_setting();
    for (const char* id : {"0-1+1-6", "1-6+3-6", "0-1+1-2+1-5+2-6+5-6"}) {
        const auto pattern = paper_pattern(id);
        const auto responses = compute_responses(paper_layout(), pattern, setting);
        const auto error = [&](const char* model) {
            return calibrate(find_tile_model(model), {paper_layout(), pattern, setting, responses}).objective;
        };
        EXPECT_LE(error("ring10"), error("paper6")) << id;
    }
}

TEST(Calibration, IsDeterministicAndItsScenarioErrorsSumToTheObjective) {
    const Setting setting = paper_setting();
    const auto responses = compute_responses(paper_layout(), paper_pattern("0-1+1-6"), setting);
    const Calibration first = calibrate_paper6(responses, setting);
    const Calibration again = calibrate_paper6(responses, setting);
    EXPECT_EQ(first.objective, again.objective);
    EXPECT_EQ(paper6_values(first).A, paper6_values(again).A);
    EXPECT_EQ(first.cost, again.cost);
    ASSERT_EQ(first.scenario_errors.size(), 5U);
    EXPECT_NEAR(std::accumulate(first.scenario_errors.begin(), first.scenario_errors.end(), 0.0),
                first.objective, 1e-12 * first.objective);
    EXPECT_TRUE(first.converged);
    const Objective objective(responses, setting);
    EXPECT_EQ(objective.value(RingHexagon(setting).displacements(paper6_values(first))), first.objective);
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
    const auto responses = linear_responses(RingHexagon(setting).displacements(truth), setting);
    const Calibration found = calibrate_paper6(responses, softer);
    EXPECT_NE(std::ranges::find(found.at_bound, "A"), found.at_bound.end());
}

TEST(Calibration, StaysWithinItsBudget) {
    const Setting setting = paper_setting();
    const auto responses = compute_responses(paper_layout(), paper_pattern("0-1+1-6"), setting);
    const Calibration found = calibrate_paper6(responses, setting, {.budget = 30});
    EXPECT_EQ(found.cost, 30);
    EXPECT_FALSE(found.converged);
}

/// A model without parameters answers at the magnitudes of the setting, which must be those of the responses.
TEST(Calibration, RefusesResponsesAtOtherMagnitudes) {
    const Setting setting = paper_setting();
    const auto pattern = paper_pattern("0-1+1-6");
    const auto responses = compute_responses(paper_layout(), pattern, setting);
    const auto complaint_with = [&](const Setting& other) {
        return test::complaint_of([&] {
            (void)calibrate(find_tile_model("full"), {paper_layout(), pattern, other, responses});
        });
    };
    Setting fewer = setting;
    fewer.magnitudes = 5;
    EXPECT_THAT(complaint_with(fewer),
                testing::HasSubstr("has 10 samples, and the setting has 5 magnitudes"));
    Setting larger = setting;
    larger.scenarios[1].max_magnitude *= 2.0;
    EXPECT_THAT(complaint_with(larger),
                testing::HasSubstr("sample 1 of the response to '" + setting.scenarios[1].name + "'"));
}

TEST(Calibration, RefusesBadOptionsAndResponsesWithoutAUsableSample) {
    const Setting setting = paper_setting();
    auto responses = linear_responses(UnitDisplacements(5, mechanics::NodeValues::Ones(6, 6)), setting);
    EXPECT_THROW((void)calibrate_paper6(responses, setting, {.optimizer = "ceres"}), base::InputError);
    EXPECT_THROW((void)calibrate_paper6(responses, setting, {.starts = 0}), base::InputError);
    EXPECT_THROW((void)calibrate_paper6(responses, setting, {.budget = 0}), base::InputError);
    Setting invalid = setting;
    invalid.scenarios[0].loads[0].interface_node = -1;
    EXPECT_THROW((void)calibrate_paper6(responses, invalid), base::InputError);
    for (auto& response : responses) {
        for (auto& sample : response.samples) sample.converged = false;
    }
    EXPECT_THROW((void)calibrate_paper6(responses, setting), base::NumericalError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
