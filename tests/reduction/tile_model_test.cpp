// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/reduction/calibration/difference_problem.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/models/tile_model.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <numeric>

namespace fretwork::reduction {
namespace THIS_TEST {

using testing::HasSubstr;

/// Any values inside of the bounds, to build a tile with.
std::vector<double> middle_values(const TileModel& model, const Setting& setting) {
    std::vector<double> values;
    for (const TileParameter& parameter : model.parameters) {
        const auto bounds = parameter.bounds(setting);
        values.push_back(parameter.scale == TileParameter::Scale::Logarithmic
                             ? std::sqrt(bounds.lower * bounds.upper)
                             : 0.5 * (bounds.lower + bounds.upper));
    }
    return values;
}

TEST(TileModels, AreFoundByName) {
    for (const TileModel& model : tile_models()) EXPECT_EQ(&find_tile_model(model.name), &model);
    try {
        (void)find_tile_model("papr6");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("paper6"));
    }
}

/// Each spring to the ground resists some motions; the one that it resists most is named.
TEST(TileModels, OfAStiffnessThatResistsARigidMotionAreRefusedWithTheMotion) {
    const Setting setting = paper_setting();
    const geometry::Polygon polygon = geometry::regular_polygon(6, setting.tile_side);
    const auto fan = pattern::make_fan(paper_layout(), paper_pattern("0-1+1-6"), 6);
    const TileInput input{paper_layout(), fan, setting, polygon, {}};
    const Eigen::MatrixXd free =
        condensed_frame(fan_frame(paper_layout(), fan, polygon, setting), fan.interface_node_count);
    const auto complaint_with = [&](const Eigen::MatrixXd& stiffness) {
        TileModel model = find_tile_model("condensed");
        model.name = "mine";
        model.build = [&](const TileInput&) { return stiffness_tile(stiffness); };
        return test::complaint_of([&] { (void)build_tile(model, input); });
    };
    EXPECT_NO_THROW((void)build_tile(find_tile_model("condensed"), input));
    const double spring = 1e-3 * free.cwiseAbs().maxCoeff();
    constexpr std::array kMotions = {"translation along x", "translation along y", "translation along z"};
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::MatrixXd held = free;
        for (Eigen::Index i = axis; i < held.rows(); i += 6) held(i, i) += spring;
        EXPECT_THAT(complaint_with(held),
                    AllOf(HasSubstr("tile model mine"), HasSubstr(kMotions[static_cast<std::size_t>(axis)])));
    }
    Eigen::MatrixXd turning = free;
    for (Eigen::Index i = 5; i < turning.rows(); i += 6)
        turning(i, i) += spring * setting.tile_side * setting.tile_side;
    EXPECT_THAT(complaint_with(turning), HasSubstr("rotation about z"));
    EXPECT_THAT(complaint_with(NAN * free), HasSubstr("not finite"));
}

TEST(TileModels, HaveParametersWithUnitsAndBounds) {
    const Setting setting = paper_setting();
    for (const TileModel& model : tile_models()) {
        for (std::size_t i = 0; i < model.parameters.size(); ++i) {
            const TileParameter& parameter = model.parameters[i];
            EXPECT_EQ(parameter_index(model, parameter.name), i);
            EXPECT_FALSE(parameter.unit.empty()) << model.name << " " << parameter.name;
            EXPECT_LT(parameter.bounds(setting).lower, parameter.bounds(setting).upper);
        }
        EXPECT_THROW((void)parameter_index(model, "no such name"), base::InputError);
    }
}

TEST(TileModels, BuildATileBetweenTheInterfaceNodesOfAnyPolygon) {
    const Setting setting = paper_setting();
    const geometry::Polygon irregular = {
        {0.0, 0.0}, {0.03, -0.004}, {0.05, 0.02}, {0.035, 0.045}, {-0.002, 0.03}};
    const auto fan = pattern::make_fan(paper_layout(), paper_pattern("0-1+1-6"), 5);
    for (const TileModel& model : tile_models()) {
        const auto values = middle_values(model, setting);
        const auto tile = model.build({paper_layout(), fan, setting, irregular, values});
        ASSERT_NE(tile, nullptr) << model.name;
        std::vector<Eigen::Vector3d> nodes;
        std::vector<mechanics::NodeIndex> kept;
        for (std::size_t i = 0; i < 5; ++i) {
            const auto& a = irregular[i];
            const auto& b = irregular[(i + 1) % 5];
            nodes.emplace_back((a.x + b.x) / 2, (a.y + b.y) / 2, 0.0);
            kept.emplace_back(i);
        }
        const auto K = mechanics::condense(assemble(tile_parts(*tile, nodes)), kept);
        EXPECT_EQ(K.rows(), 30) << model.name;
        EXPECT_LT((K - K.transpose()).norm(), 1e-12 * K.norm()) << model.name;
    }
}

/// For every row and a real pattern, the objective is the sum of the scenarios' errors.
TEST(TileModels, HaveAnErrorForEachScenarioThatSumsToTheObjective) {
    const Setting setting = paper_setting();
    const auto pattern = paper_pattern("0-1+1-6");
    const auto responses = compute_responses(paper_layout(), pattern, setting);
    for (const TileModel& model : tile_models()) {
        const Calibration result = calibrate(model, {paper_layout(), pattern, setting, responses});
        EXPECT_EQ(result.model, model.name);
        EXPECT_EQ(result.parameters.size(), model.parameters.size());
        const double sum = std::accumulate(result.scenario_errors.begin(), result.scenario_errors.end(), 0.0);
        EXPECT_NEAR(sum, result.objective, 1e-12 * sum);
        EXPECT_GT(result.objective, 0.0);
    }
}

TEST(TileModels, FullDiffersFromResponsesOnlyByItsDivisions) {
    Setting setting = paper_setting();
    const auto pattern = paper_pattern("0-1+1-6");
    const auto error_with = [&](int divisions) {
        setting.divisions = divisions;
        const auto responses = compute_responses(paper_layout(), pattern, setting);
        return calibrate(find_tile_model("full"), {paper_layout(), pattern, setting, responses}).objective;
    };
    EXPECT_LT(error_with(1), 1e-16) << "the same beams, one element each: only rounding is left";
    EXPECT_GT(error_with(2), 1e-12);
}

TEST(Calibrations, GiveTheirParametersInTheOrderOfTheRow) {
    const TileModel& model = find_tile_model("paper6");
    Calibration calibration;
    calibration.parameters = {{"A", 1}, {"I2", 2}, {"I3", 3}, {"J", 4}, {"R", 6}, {"theta", 5}};
    EXPECT_EQ(parameter_values(calibration, model), (std::vector<double>{1, 2, 3, 4, 5, 6}));
    calibration.parameters.pop_back();
    EXPECT_THROW((void)parameter_values(calibration, model), base::InputError);
    calibration.parameters.push_back({"theta", 5});
    calibration.parameters.push_back({"I4", 7});
    EXPECT_THROW((void)parameter_values(calibration, model), base::InputError);
}

TEST(DifferenceProblem, AgreesWithTheAnalyticProblemOfARingWithLinks) {
    const Setting setting = paper_setting();
    const auto pattern = paper_pattern("0-1+1-6");
    const auto responses = compute_responses(paper_layout(), pattern, setting);
    const Objective objective(responses, setting);
    const RingHexagon hexagon(setting);
    for (const RingParameters& parameters : {paper6_parameters(), ring10_parameters()}) {
        const TileModel& model = find_tile_model(parameters.model);
        const ModelTile tile(model, paper_layout(), pattern, setting);
        const DifferenceProblem numeric(model, tile, objective, setting);
        const RingProblem analytic(hexagon, parameters, objective, setting);
        const auto count = static_cast<Eigen::Index>(model.parameters.size());
        base::RandomStream random(3, 0);
        for (int trial = 0; trial < 3; ++trial) {
            Eigen::VectorXd shares(count);
            for (double& share : shares) share = 0.3 + 0.4 * random.uniform();
            const Eigen::VectorXd point = numeric.bounds().at_shares(shares);
            const auto wanted = analytic.gradient(analytic.point(numeric.parameter_values(point)), 0.0);
            const auto found = numeric.gradient(point, 0.0);
            EXPECT_NEAR(found.objective, wanted.objective, 1e-7 * wanted.objective);
            // The variables differ by constants only, but the last one: R is a share there. What remains: the
            // third derivative over a step of 1e-5 of the range, and condensing's rounding over that step.
            const Eigen::VectorXd difference = found.gradient - wanted.gradient;
            EXPECT_LT(difference.head(count - 1).norm(), 1e-4 * wanted.gradient.head(count - 1).norm())
                << model.name;
        }
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
