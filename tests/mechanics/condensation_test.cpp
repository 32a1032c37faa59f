// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/linear_solver.hpp>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace {

std::vector<NodeIndex> tips() {
    std::vector<NodeIndex> nodes;
    for (int i = 0; i < 6; ++i) nodes.emplace_back(i);
    return nodes;
}

TEST(Condensation, LoadsOnKeptNodesGiveTheDisplacementsOfTheWholeFrame) {
    Frame frame = sample::flat_wheel();
    for (Beam& beam : frame.beams) beam.divisions = 2;
    frame.beams[3].releases = {{1, {{false, false, false, false, false, true}}}};
    frame.loads.push_back({NodeIndex(3), {0.5, -0.3, 0.7}, {0.001, 0.002, 0.003}});
    frame.loads.push_back({NodeIndex(5), {0.1, 0.2, -0.7}});
    const Assembly whole = assemble(frame);
    Assembly reduced;
    reduced.nodes.assign(frame.nodes.begin(), frame.nodes.begin() + 6);
    reduced.elements.push_back(linear_element(tips(), condense(whole, tips())));
    reduced.supports = frame.supports;
    reduced.loads = whole.loads.topRows(6);
    reduced.reported_nodes = 6;
    const Solution expected = solve_linear(whole);
    const Solution found = solve_linear(reduced);
    EXPECT_LT((found.displacements - expected.displacements.topRows(6)).norm(),
              1e-10 * expected.displacements.norm());
    EXPECT_LT((found.reactions - expected.reactions.topRows(6)).norm(), 1e-10 * expected.reactions.norm());
    EXPECT_NEAR(found.energy, expected.energy, 1e-10 * expected.energy);
}

TEST(Condensation, StiffnessHasTheSixRigidMotionsAndNoOthers) {
    const Eigen::MatrixXd stiffness = condense(assemble(sample::flat_wheel()), tips());
    EXPECT_EQ(stiffness, stiffness.transpose());
    // Lengths and rotations differ in unit: count with lengths in centimetres.
    Eigen::MatrixXd scaled = stiffness;
    for (Eigen::Index i = 0; i < 36; ++i) {
        if (i % 6 >= 3) continue;
        scaled.row(i) *= 0.01;
        scaled.col(i) *= 0.01;
    }
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues();
    EXPECT_LT(values.head(6).cwiseAbs().maxCoeff(), 1e-12 * values[35]);
    EXPECT_GT(values[6], 1e-8 * values[35]);
}

TEST(Condensation, OntoAllNodesIsTheStiffnessItself) {
    const Frame frame = sample::cantilever();
    const Assembly assembly = assemble(frame);
    Eigen::MatrixXd expected;
    assembly.elements[0]->rest_stiffness(expected);
    const NodeIndex both[] = {NodeIndex(0), NodeIndex(1)};
    EXPECT_EQ(condense(assembly, both), expected);
}

TEST(Condensation, NodesOutOfRangeOrTwiceAreRefused) {
    const Assembly assembly = assemble(sample::cantilever());
    const NodeIndex outside[] = {NodeIndex(0), NodeIndex(2)};
    const NodeIndex twice[] = {NodeIndex(0), NodeIndex(0)};
    EXPECT_THROW(condense(assembly, outside), base::InputError);
    EXPECT_THROW(condense(assembly, twice), base::InputError);
}

TEST(Condensation, InnerNodesThatCanMoveFreelyAreRefused) {
    Frame frame = sample::cantilever();
    frame.nodes.emplace_back(0.0, 5.0, 0.0);
    frame.nodes.emplace_back(0.0, 6.0, 0.0);
    frame.beams.push_back(frame.beams[0]);
    frame.beams[1].nodes = {NodeIndex(2), NodeIndex(3)};
    sample::clamp(frame, 2);
    const NodeIndex kept[] = {NodeIndex(0)};
    EXPECT_THROW(condense(assemble(frame), kept), base::NumericalError);
}

}  // namespace
}  // namespace fretwork::mechanics
