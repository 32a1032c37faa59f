// SPDX-License-Identifier: GPL-3.0-or-later
#include "corotational_frame.hpp"
#include "reduction/fixtures.hpp"
#include "symmetric_stiffness.hpp"

#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>

#include <gtest/gtest.h>

namespace fretwork::tile_models {
namespace {

using namespace reduction;

/// A row for small displacements with values for its parameters, and the same in a frame that turns.
struct Pair {
    TileModel linear;
    TileModel turning = corotational(linear);
    std::vector<double> values;
    Setting setting = paper_setting();

    [[nodiscard]] mechanics::Assembly tile(const TileModel& model) const {
        return assemble(ModelTile(model, paper_layout(), paper_pattern("0-1+1-6"), setting).parts(values));
    }
};

std::vector<double> ring_values(const RingParameters& parameters) {
    base::RandomStream random(7, 0);
    const Eigen::VectorXd values =
        parameters.select(random_parameters(paper_setting(), random, 0.4, 0.6).parts());
    return {values.begin(), values.end()};
}

std::vector<Pair> pairs() {
    std::vector<Pair> result;
    result.push_back({.linear = find_tile_model("paper6"), .values = ring_values(paper6_parameters())});
    result.push_back({.linear = find_tile_model("ring10"), .values = ring_values(ring10_parameters())});
    result.push_back({.linear = symmetric_stiffness_model(),
                      .values = condensed_values(paper_layout(), paper_pattern("0-1+1-6"), paper_setting())});
    return result;
}

TEST(CorotationalFrame, HasTheOtherRowsStiffnessAtRest) {
    for (const Pair& pair : pairs()) {
        const auto kept = mechanics::first_nodes(6);
        const Eigen::MatrixXd K = mechanics::condense(pair.tile(pair.linear), kept);
        EXPECT_LT((mechanics::condense(pair.tile(pair.turning), kept) - K).norm(), 1e-9 * K.norm())
            << pair.turning.name;
    }
}

TEST(CorotationalFrame, TurnsAsAWholeWithoutForce) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.5, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()));
    for (const Pair& pair : pairs()) {
        const mechanics::Assembly tile = pair.tile(pair.turning);
        ASSERT_EQ(tile.elements.size(), 1U);
        std::vector<mechanics::NodeState> states;
        for (const Eigen::Vector3d& place : tile.nodes) states.push_back({turn * place - place, turn});
        mechanics::ElementResponse response;
        tile.elements[0]->evaluate(states, mechanics::Demand::Tangent, response);
        // Would bend the tile by its own size, m.
        const double usual = response.tangent.topLeftCorner<3, 3>().norm() * 0.03;
        EXPECT_LT(response.force.norm(), 1e-9 * usual) << pair.turning.name;
        EXPECT_LT(std::abs(response.energy), 1e-9 * usual * 0.03) << pair.turning.name;
    }
}

TEST(CorotationalFrame, IsFittedAsTheOtherRow) {
    const Setting setting = paper_setting();
    const auto pattern = paper_pattern("0-1+1-6");
    const auto responses = compute_responses(paper_layout(), pattern, setting);
    const CalibrationInput input{paper_layout(), pattern, setting, responses};
    const TileModel& paper6 = find_tile_model("paper6");
    const Calibration turning = calibrate(corotational(paper6), input);
    EXPECT_EQ(turning.model, "corotational_paper6");
    EXPECT_EQ(turning.parameters, calibrate(paper6, input).parameters);
}

}  // namespace
}  // namespace fretwork::tile_models
