// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios, responses, the ring with links, calibrations and effective properties for layouts with any
// number of interface nodes a side.
#include "fixtures.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/pattern/sample.hpp>
#include <fretwork/reduction/calibration/difference_problem.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/ring/ring_tile.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace fretwork::reduction {
namespace THIS_TEST {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// Two interface nodes a side, which every pattern uses.
const pattern::NodeLayout& two_node_layout() {
    static const pattern::NodeLayout layout = pattern::find_node_layout("doors6");
    return layout;
}

std::vector<pattern::Pattern> some_patterns(const pattern::NodeLayout& layout, std::size_t count) {
    return pattern::PatternSampler(layout, {.edges = pattern::default_edge_range(layout)}, 1).draw(count);
}

/// Coarse and quick: these tests compare, they do not measure.
Setting quick_setting() {
    Setting setting = paper_setting();
    setting.divisions = 1;
    setting.magnitudes = 2;
    return setting;
}

/// Force and moment about the origin that a scenario puts on each side.
std::array<Eigen::Matrix<double, 6, 1>, 6> side_resultants(const Scenario& scenario,
                                                           const std::vector<Vector3d>& nodes) {
    std::array<Eigen::Matrix<double, 6, 1>, 6> sums;
    for (auto& sum : sums) sum.setZero();
    for (const Scenario::Load& load : scenario.loads) {
        const Vector3d force(load.force.data());
        const auto node = static_cast<std::size_t>(load.interface_node);
        auto& sum = sums[node * 6 / nodes.size()];
        sum.head<3>() += force;
        sum.tail<3>() += Vector3d(load.moment.data()) + nodes[node].cross(force);
    }
    return sums;
}

std::vector<Vector3d> interface_nodes(const pattern::NodeLayout& layout, const Setting& setting) {
    auto nodes = pattern_frame(layout, some_patterns(layout, 1).front(), setting).nodes;
    nodes.resize(layout.interface_nodes().size() * static_cast<std::size_t>(setting.sides));
    return nodes;
}

TEST(SpreadScenario, LeavesTilesOfOneNodeASideAsTheyAre) {
    for (const Scenario& scenario : paper_scenarios()) EXPECT_EQ(spread_over_sides(scenario, 1), scenario);
}

TEST(SpreadScenario, KeepsForceAndMomentOfEachSide) {
    const Setting setting = paper_setting();
    const auto one = interface_nodes(paper_layout(), setting);
    const auto two = interface_nodes(two_node_layout(), setting);
    for (const Scenario& scenario : setting.scenarios) {
        const auto expected = side_resultants(scenario, one);
        const auto spread = side_resultants(spread_over_sides(scenario, 2), two);
        for (std::size_t side = 0; side < 6; ++side)
            EXPECT_LT((spread[side] - expected[side]).norm(), 1e-15) << scenario.name << ", side " << side;
    }
}

TEST(SpreadScenario, HoldsAllNodesOfASideAlike) {
    const Scenario& axial = paper_scenarios().front();
    const Scenario spread = spread_over_sides(axial, 3);
    ASSERT_EQ(spread.supports.size(), 3 * axial.supports.size());
    for (std::size_t i = 0; i < spread.supports.size(); ++i) {
        EXPECT_EQ(spread.supports[i].interface_node / 3, axial.supports[i / 3].interface_node);
        EXPECT_EQ(spread.supports[i].fixed, axial.supports[i / 3].fixed);
    }
}

TEST(SpreadScenario, RefusesCountsOfNoLayoutAndNodesOfNoPolygon) {
    const Scenario& axial = paper_scenarios().front();
    constexpr int kHuge = std::numeric_limits<int>::max();
    for (const int nodes : {-1, 0, kMostNodesASide + 1, kHuge})
        EXPECT_THROW((void)spread_over_sides(axial, nodes), base::InputError) << nodes;
    for (const int node : {-1, kLargestInterfaceNode + 1, kHuge}) {
        Scenario held = axial;
        held.supports.front().interface_node = node;
        EXPECT_THROW((void)spread_over_sides(held, 2), base::InputError) << node;
        Scenario loaded = axial;
        loaded.loads.front().interface_node = node;
        EXPECT_THROW((void)spread_over_sides(loaded, 2), base::InputError) << node;
    }
}

/// One equilibrium, two ways: the tile's frame with its loads, and its condensed stiffness.
TEST(AnyLayout, CondensedTilesMoveAsTheirFramesDo) {
    const Setting setting = quick_setting();
    for (const std::string& name : pattern::layout_names()) {
        const auto layout = pattern::find_node_layout(name);
        const auto a_side = static_cast<int>(layout.interface_nodes().size());
        for (const pattern::Pattern& pattern : some_patterns(layout, 2)) {
            const auto tile = pattern_frame(layout, pattern, setting);
            const auto model = unit_displacements(condensed_frame(tile, 6 * a_side), setting);
            for (std::size_t s = 0; s < setting.scenarios.size(); ++s) {
                Scenario unit = spread_over_sides(setting.scenarios[s], a_side);
                unit.max_magnitude = 1.0;
                const auto whole = mechanics::solve_linear(mechanics::assemble(scenario_frame(tile, unit)));
                // Both are backward stable; soft patterns have condition numbers of 1e8.
                EXPECT_LT(relative_difference(model[s], whole.displacements.topRows(6 * a_side)), 1e-6)
                    << pattern_id(layout, pattern) << ", " << unit.name;
            }
        }
    }
}

TEST(AnyLayout, ResponsesBeginAlongTheLinearOnes) {
    Setting setting = quick_setting();
    for (Scenario& scenario : setting.scenarios) scenario.max_magnitude *= 1e-6;
    for (const std::string& name : pattern::layout_names()) {
        const auto layout = pattern::find_node_layout(name);
        const auto a_side = static_cast<int>(layout.interface_nodes().size());
        const pattern::Pattern pattern = some_patterns(layout, 1).front();
        const auto linear =
            unit_displacements(condensed_frame(pattern_frame(layout, pattern, setting), 6 * a_side), setting);
        const auto responses = compute_responses(layout, pattern, setting);
        for (std::size_t s = 0; s < responses.size(); ++s) {
            const Response::Sample& sample = responses[s].samples.back();
            ASSERT_TRUE(sample.converged) << pattern_id(layout, pattern);
            // A millionth of the load bends it by a millionth: the second order is as small beside the first.
            EXPECT_LT(relative_difference(sample.displacements, sample.magnitude * linear[s]), 1e-4)
                << pattern_id(layout, pattern) << ", " << responses[s].scenario;
        }
    }
}

TEST(AnyLayout, RingIsThePolygonOfInterfaceNodesTurnedAndScaled) {
    const Setting setting = paper_setting();
    const double theta = 0.2;
    const double R = 0.013;
    const auto polygon = geometry::regular_polygon(setting.sides, setting.tile_side);
    const double apothem = setting.tile_side * std::numbers::sqrt3 / 2.0;
    const auto frame =
        ring_tile(Paper6Parameters{1e-6, 1e-12, 1e-12, 1e-12, theta, R}, two_node_layout(), setting, polygon);
    ASSERT_EQ(frame.nodes.size(), 24U);
    EXPECT_EQ(frame.beams.size(), 24U);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(theta, Vector3d::UnitZ()).toRotationMatrix();
    for (std::size_t i = 0; i < 12; ++i)
        EXPECT_LT((frame.nodes[12 + i] - R / apothem * turn * frame.nodes[i]).norm(), 1e-15);
}

/// The fast solver and the built tile are one problem where both can be had.
TEST(AnyLayout, ADifferenceProblemIsTheRingProblemOfOneNodeASide) {
    const Setting setting = quick_setting();
    const pattern::Pattern pattern = paper_pattern("0-1+1-6");
    const Objective objective(compute_responses(paper_layout(), pattern, setting), setting);
    const TileModel& model = find_tile_model("paper6");
    const auto fast = model.problem(objective, paper_layout(), setting);
    ASSERT_NE(fast, nullptr);
    const ModelTile tile(model, paper_layout(), pattern, setting);
    const DifferenceProblem built(model, tile, objective, setting);
    base::RandomStream random(3, 0);
    for (int trial = 0; trial < 5; ++trial) {
        const Paper6Parameters parameters = random_parameters(setting, random);
        const auto values = parameters.values();
        const double expected = objective.value(tile.displacements(values));
        Eigen::VectorXd x(6);
        for (int i = 0; i < 6; ++i)
            x[i] = built.is_logarithm(i) ? std::log(values[static_cast<std::size_t>(i)])
                                         : values[static_cast<std::size_t>(i)];
        // The logarithm and back: some 1e-16, which soft rings magnify.
        EXPECT_NEAR(built.value(x), expected, 1e-9 * expected);
        Eigen::VectorXd y = x;
        const RingParts units = ring_units(setting);
        const Eigen::VectorXd own = paper6_parameters().select(units);
        for (int i = 0; i < 6; ++i) y[i] = fast->is_logarithm(i) ? x[i] - std::log(own[i]) : x[i] / own[i];
        EXPECT_NEAR(fast->value(y), expected, 1e-6 * expected);
    }
}

/// A ring's own linear responses are fitted to the last digits, whatever the layout.
TEST(AnyLayout, CalibrationFindsTheRingThatMadeTheResponses) {
    const Setting setting = quick_setting();
    const TileModel& model = find_tile_model("paper6");
    const pattern::Pattern pattern = some_patterns(two_node_layout(), 1).front();
    const ModelTile tile(model, two_node_layout(), pattern, setting);
    base::RandomStream random(5, 0);
    const Paper6Parameters truth = random_parameters(setting, random, 0.4, 0.6);
    const auto responses = linear_responses(tile.displacements(truth.values()), setting);
    EXPECT_EQ(model.problem(Objective(responses, setting), two_node_layout(), setting), nullptr);
    const Calibration found =
        calibrate(model, {two_node_layout(), pattern, setting, responses}, {.starts = 4, .budget = 4000});
    // A wrong ring leaves some 1 to 100.
    EXPECT_LT(found.objective, 1e-3);
    EXPECT_NEAR(paper6_values(found).R, truth.R, 1e-3 * truth.R);
    EXPECT_NEAR(paper6_values(found).theta, truth.theta, 1e-3);
}

/// Sections of a thousandth and a thousand times the usual: stiffnesses 1e12 apart, which round-off can make
/// indefinite. A search goes elsewhere then.
TEST(AnyLayout, ADifferenceProblemHasAValueOrNoneAtItsBounds) {
    const Setting setting = quick_setting();
    const TileModel& model = find_tile_model("paper6");
    const pattern::Pattern pattern = some_patterns(two_node_layout(), 1).front();
    const Objective objective(compute_responses(two_node_layout(), pattern, setting), setting);
    const ModelTile tile(model, two_node_layout(), pattern, setting);
    const DifferenceProblem problem(model, tile, objective, setting);
    for (int corner = 0; corner < 64; ++corner) {
        Eigen::VectorXd x = problem.bounds().lower;
        for (int i = 0; i < 6; ++i) {
            if ((corner >> i) & 1) x[i] = problem.bounds().upper[i];
        }
        EXPECT_NO_THROW((void)problem.value(x)) << "corner " << corner;
    }
}

TEST(AnyLayout, ASquareTileIsCalibratedToo) {
    Setting setting = quick_setting();
    setting.sides = 4;
    setting.scenarios.resize(1);
    setting.scenarios[0].supports = {{0, mechanics::DofSet::all()}};
    setting.scenarios[0].loads = {{2, {0.0, 1.0, 0.0}, {}}};
    const pattern::Pattern pattern = paper_pattern("0-1+1-6");
    const auto responses = compute_responses(paper_layout(), pattern, setting);
    const Calibration found =
        calibrate(find_tile_model("paper6"), {paper_layout(), pattern, setting, responses},
                  {.starts = 2, .budget = 2000});
    EXPECT_TRUE(std::isfinite(found.objective));
}

TEST(AnyLayout, ResponsesOfAnotherLayoutAreRefused) {
    const Setting setting = quick_setting();
    const pattern::Pattern one = paper_pattern("0-1+1-6");
    const pattern::Pattern two = some_patterns(two_node_layout(), 1).front();
    const auto of_one = compute_responses(paper_layout(), one, setting);
    const auto of_two = compute_responses(two_node_layout(), two, setting);
    EXPECT_THROW((void)calibrate(find_tile_model("paper6"), {paper_layout(), one, setting, of_two}),
                 base::InputError);
    EXPECT_THROW((void)calibrate(find_tile_model("condensed"), {two_node_layout(), two, setting, of_one}),
                 base::InputError);
}

/// Which interface node of the next tile is which: found by where they lie, not by their numbers.
MatrixXd pairs_by_place(const std::vector<Vector3d>& nodes, double apothem) {
    MatrixXd pairs = MatrixXd::Zero(static_cast<Eigen::Index>(3 * nodes.size()),
                                    static_cast<Eigen::Index>(3 * nodes.size() / 2));
    Eigen::Index pair = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (std::size_t j = i + 1; j < nodes.size(); ++j) {
            const Vector3d across = nodes[j] - nodes[i];
            const bool by_lattice =
                std::abs(across.norm() - 2.0 * apothem) < 1e-9 &&
                std::abs(std::remainder(std::atan2(across.y(), across.x()) - std::numbers::pi / 2.0,
                                        std::numbers::pi / 3.0)) < 1e-9;
            if (!by_lattice) continue;
            for (const std::size_t node : {i, j})
                pairs.block<3, 3>(static_cast<Eigen::Index>(3 * node), 3 * pair).setIdentity();
            ++pair;
        }
    }
    EXPECT_EQ(2 * static_cast<std::size_t>(pair), nodes.size());
    return pairs;
}

TEST(AnyLayout, MembraneStiffnessIsThatOfThePeriodicTile) {
    const Setting setting = paper_setting();
    const double apothem = setting.tile_side * std::numbers::sqrt3 / 2.0;
    const auto nodes = interface_nodes(two_node_layout(), setting);
    const MatrixXd pairs = pairs_by_place(nodes, apothem);
    for (const pattern::Pattern& pattern : some_patterns(two_node_layout(), 5)) {
        const auto frame = pattern_frame(two_node_layout(), pattern, setting);
        const MatrixXd K = condensed_frame(frame, 12);
        std::vector<Eigen::Index> dofs;
        MatrixXd strained = MatrixXd::Zero(36, 3);
        for (int n = 0; n < 12; ++n) {
            for (const int dof : {0, 1, 5}) dofs.push_back(6 * n + dof);
            const Vector3d& p = nodes[n];
            strained.middleRows<3>(3 * n) << p.x(), 0, p.y() / 2, 0, p.y(), p.x() / 2, 0, 0, 0;
        }
        const MatrixXd membrane = K(dofs, dofs);
        const MatrixXd lattice = pairs.transpose() * membrane * pairs;
        const MatrixXd fluctuation =
            -lattice.completeOrthogonalDecomposition().solve(pairs.transpose() * membrane * strained);
        const MatrixXd moved = strained + pairs * fluctuation;
        const double area = 6.0 * apothem * setting.tile_side / 2.0;
        const Matrix3d expected = moved.transpose() * membrane * moved / area;
        const auto found = effective_properties(two_node_layout(), pattern, setting);
        EXPECT_LT(relative_difference(found.A, expected), 1e-8) << pattern_id(two_node_layout(), pattern);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
