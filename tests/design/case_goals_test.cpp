// SPDX-License-Identifier: GPL-3.0-or-later
#include "hidden.hpp"
#include "support.hpp"

#include <fretwork/base/random.hpp>
#include <fretwork/design/goals/case_goals.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace fretwork::design::detail {
namespace THIS_TEST {

using mechanics::NodeValues;
using test::complaint_of;
using testing::HasSubstr;

const simulation::NodesInBox kAll{{-10, -10, 10, 10}};

tiling::Tessellation tessellation() {
    return test::honeycomb(3, 2, {"0-1+1-6"}).tessellation;
}

NodeValues random_displacements(std::size_t nodes, std::uint64_t seed) {
    base::SplitMix64 random(seed);
    NodeValues rows(static_cast<Eigen::Index>(nodes), 6);
    for (double& value : rows.reshaped()) value = 0.05 * (random.share() - 0.5);
    return rows;
}

CaseGoals goals_of(std::vector<Goal> goals) {
    return {Target{"", "", std::move(goals)}, "tip", "tip", tessellation()};
}

/// A slope of one in x, far larger than the surface.
std::filesystem::path slope_mesh(const test::TemporaryFolder& folder) {
    return folder.file("slope.obj", "v -9 -9 -9\nv 9 -9 9\nv 9 9 9\nv -9 9 -9\nf 1 2 3 4\n");
}

TEST(CaseGoals, ExpressionsAndPositionsAskForDisplacements) {
    const auto surface = tessellation();
    const auto nodes = surface.interface_nodes.size();
    NodeValues wanted = NodeValues::Zero(static_cast<Eigen::Index>(nodes), 6);
    NodesGoal positions{{}, NodesGoal::Quantity::Positions, {}};
    for (std::size_t i = 0; i < nodes; ++i) {
        const auto& place = surface.interface_nodes[i];
        wanted(static_cast<Eigen::Index>(i), 2) = 0.5 * place.x * place.x;
        positions.nodes.push_back(static_cast<int>(i));
        positions.values.push_back({place.x, std::nullopt, 0.5 * place.x * place.x});
    }
    for (const Goal& goal : {Goal{FormulaGoal{kAll, {"0", std::nullopt, "0.5*x^2"}}}, Goal{positions}}) {
        const CaseGoals goals = goals_of({goal});
        EXPECT_EQ(goals.node_count(), nodes);
        EXPECT_NEAR(goals.largest(), wanted.col(2).maxCoeff(), 1e-12);
        for (const double distance : goals.distances(wanted)) EXPECT_NEAR(distance, 0.0, 1e-12);
        NodeValues off = wanted;
        off.col(1).setConstant(7.0);  // free
        off.col(2).array() += 0.01;
        for (const double distance : goals.distances(off)) EXPECT_NEAR(distance, 0.01, 1e-12);
    }
}

TEST(CaseGoals, NodesSlideAlongASurface) {
    const test::TemporaryFolder folder;
    const CaseGoals goals = goals_of({{MeshGoal{kAll, slope_mesh(folder)}}});
    EXPECT_TRUE(goals.slides());
    const auto surface = tessellation();
    NodeValues rows = NodeValues::Zero(std::ssize(surface.interface_nodes), 6);
    for (std::size_t i = 0; i < surface.interface_nodes.size(); ++i)
        rows(static_cast<Eigen::Index>(i), 2) = surface.interface_nodes[i].x + 0.03;
    rows.col(0).array() += 0.02;
    rows.col(2).array() += 0.02;  // along the slope
    for (const double distance : goals.distances(rows)) EXPECT_NEAR(distance, 0.03 / std::sqrt(2.0), 1e-12);
}

TEST(CaseGoals, ObservationsAreTheDerivativesOfDistances) {
    const test::TemporaryFolder folder;
    NodesGoal nodes{
        {2, 5}, NodesGoal::Quantity::Displacements, {{0.01, std::nullopt, 0.02}, {std::nullopt, 0.0, 0.0}}};
    const CaseGoals goals = goals_of(
        {{nodes, 2.0}, {MeshGoal{kAll, slope_mesh(folder)}}, {RotationGoal{kAll, {0.1, 0.0, std::nullopt}}}});
    NodeValues rows = random_displacements(tessellation().interface_nodes.size(), 3);
    const NodeValues aim = random_displacements(tessellation().interface_nodes.size(), 4);
    const auto before = goals.observe(rows, aim);
    const double step = 1e-7;
    for (std::size_t i = 0; i < before.size(); ++i) {
        for (Eigen::Index d = 0; d < 6; ++d) {
            NodeValues moved = rows;
            moved(before[i].node, d) += step;
            EXPECT_NEAR((goals.observe(moved, aim)[i].residual - before[i].residual) / step,
                        before[i].direction[d], 1e-6)
                << i << " " << d;
        }
    }
}

TEST(CaseGoals, TakesTheGoalsOfItsLoadCase) {
    const Goal own{RotationGoal{kAll, {0.1, 0.0, 0.0}}};
    const Goal other{RotationGoal{kAll, {0.2, 0.0, 0.0}}, 1.0, "snow"};
    const Target target{"", "", {own, other}};
    EXPECT_GT(CaseGoals(target, "snow", "tip", tessellation()).largest(),
              1.5 * CaseGoals(target, "tip", "tip", tessellation()).largest());
}

TEST(CaseGoals, NamesTheGoalThatDoesNotFit) {
    const test::TemporaryFolder folder;
    const Goal fine{RotationGoal{kAll, {0.1, 0.0, 0.0}}};
    EXPECT_THAT(complaint_of([&] {
                    goals_of({fine, {NodesGoal{{999}, {}, {{0.0, 0.0, 0.0}}}}});
                }),
                testing::AllOf(HasSubstr("/goals/1"), HasSubstr("no interface node 999")));
    EXPECT_THAT(complaint_of([&] {
                    goals_of({{NodesGoal{{2, 5}, {}, {{0.0, 0.0, 0.01}}}}});
                }),
                testing::AllOf(HasSubstr("/goals/0: /displacements"), HasSubstr("1 value for 2 nodes")));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const NodesGoal unknown{
        {2, 5}, NodesGoal::Quantity::Positions, {{0.0, 0.0, 0.01}, {std::nullopt, 0.0, nan}}};
    EXPECT_THAT(complaint_of([&] { goals_of({{unknown}}); }),
                testing::AllOf(HasSubstr("/goals/0: /positions"), HasSubstr("node 5 that is not finite")));
    EXPECT_THAT(complaint_of([&] {
                    goals_of({{FormulaGoal{kAll, {"0.1*z", "0", "0"}}}});
                }),
                HasSubstr("/goals/0"));
    const auto points = folder.file("points.obj", "v 0 0 0\nv 1 0 0\n");
    EXPECT_THAT(complaint_of([&] { goals_of({{MeshGoal{kAll, points}}}); }), HasSubstr("no face"));
    EXPECT_THAT(complaint_of([&] {
                    goals_of({{MeshGoal{kAll, folder.path() / "none.obj"}}});
                }),
                HasSubstr("none.obj"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::design::detail
