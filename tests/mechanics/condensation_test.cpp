// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/linear_element.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/structure/condensing.hpp>

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fretwork::mechanics {
namespace THIS_TEST {

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
    reduced.elements.push_back(linear_element(tips(), {.stiffness = condense(whole, tips())}));
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

TEST(Condensation, TheOtherNodesFollowTheKeptOnesAsInTheWholeFrame) {
    for (const bool is_flat : {true, false}) {
        Frame frame = sample::flat_wheel();
        if (!is_flat) frame.nodes.back().z() += 0.003;  // membrane and bending are coupled then
        frame.loads.push_back({NodeIndex(3), {0.5, -0.3, 0.7}, {0.001, 0.002, 0.003}});
        const Assembly whole = assemble(frame);
        const NodeValues moved = solve_linear(whole).displacements;
        const Eigen::MatrixXd follow = following(whole, tips());
        const auto inner = static_cast<Eigen::Index>(frame.nodes.size()) - 6;
        ASSERT_EQ(follow.rows(), 6 * inner);
        const Eigen::VectorXd found = follow * Eigen::Map<const Eigen::VectorXd>(moved.data(), 36);
        const Eigen::Map<const Eigen::VectorXd> expected(moved.data() + 36, 6 * inner);
        EXPECT_LT((found - expected).norm(), 1e-10 * expected.norm());
    }
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

/// Divided beams held at both ends have frequencies far above those of the wheel.
TEST(Condensation, MassGivesTheLowFrequenciesOfTheWholeFrame) {
    Frame frame = sample::flat_wheel();
    for (Beam& beam : frame.beams) beam.divisions = 3;
    const Assembly whole = assemble(frame);
    std::vector<NodeIndex> kept;
    for (int i = 0; i < 12; ++i) kept.emplace_back(i);
    Assembly reduced;
    reduced.nodes = frame.nodes;
    reduced.elements.push_back(
        linear_element(kept, {.stiffness = condense(whole, kept), .mass = condense_mass(whole, kept)}));
    reduced.supports = frame.supports;
    reduced.loads = NodeValues::Zero(12, kDofsPerNode);
    reduced.reported_nodes = 12;
    const auto expected = vibration_modes(whole, 3);
    const auto found = vibration_modes(reduced, 3);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GE(found[i].value, expected[i].value * (1.0 - 1e-9));
        EXPECT_LT(found[i].value,
                  expected[i].value * 1.001);  // the inner nodes' own frequencies are 20 times as high
    }
}

TEST(Condensation, MassInRigidMotionsIsThatOfTheBeams) {
    const Frame frame = sample::flat_wheel();
    const Eigen::MatrixXd mass = condense_mass(assemble(frame), tips());
    double total = 0.0;
    for (const Beam& beam : frame.beams)
        total += 1240.0 * 4e-6 * (frame.nodes[beam.nodes[1]] - frame.nodes[beam.nodes[0]]).norm();
    for (int c = 0; c < 3; ++c) {
        Eigen::VectorXd motion = Eigen::VectorXd::Zero(36);
        for (Eigen::Index i = c; i < 36; i += 6) motion[i] = 1.0;
        EXPECT_NEAR(motion.dot(mass * motion), total, 1e-9 * total);
    }
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

/// The nodes of a random frame lie in a plane or in space.
enum class Extent { Flat, Spatial };

/// A tree of rigidly joined beams, so that nothing is a mechanism, and as many further beams with hinges.
Frame random_frame(sample::Random& random, Extent extent) {
    const auto below = [&](int count) {
        return std::min(static_cast<int>((random.next() + 1.0) / 2.0 * count), count - 1);
    };
    Frame frame;
    const int nodes = 8 + below(12);
    for (int i = 0; i < nodes; ++i) {
        // Beside a grid: next to a beam of no length, all others would be rounding.
        const int row = i / 5;
        frame.nodes.push_back(random.vector(0.004) + Eigen::Vector3d(0.01 * (i % 5), 0.01 * row, 0.0));
        if (extent == Extent::Flat) frame.nodes.back().z() = 0.0;
    }
    for (int i = 1; i < nodes; ++i) frame.beams.push_back(sample::beam_between(below(i), i));
    for (int i = 1; i < nodes; ++i) {
        Beam beam = sample::beam_between(i - 1, i);
        beam.divisions = 1 + below(2);
        beam.releases = {{below(2), {}}};
        beam.releases[0].free.contains[static_cast<std::size_t>(below(kDofsPerNode))] = true;
        frame.beams.push_back(beam);
    }
    for (Beam& beam : frame.beams) {
        beam.section = rectangle_section(2e-3 + 1e-3 * random.next(), 2e-3 + 1e-3 * random.next());
        if (below(2) == 0) beam.section.shear_area2 = beam.section.shear_area3 = 0.8 * beam.section.area;
    }
    return frame;
}

/// The largest difference of two stiffnesses, each entry against those of the elements at its two dofs.
double relative_difference(const structure::CondensingTask& task, const Eigen::MatrixXd& a,
                           const Eigen::MatrixXd& b) {
    Eigen::VectorXd scale = Eigen::VectorXd::Zero(a.rows());
    Eigen::MatrixXd stiffness;
    for (const auto& element : task.assembly.elements) {
        element->rest_stiffness(stiffness);
        for (std::size_t i = 0; i < element->nodes().size(); ++i) {
            const int slot = task.slot[static_cast<std::size_t>(element->nodes()[i].value)];
            if (slot >= 0)
                scale.segment<kDofsPerNode>(slot * kDofsPerNode) +=
                    stiffness.diagonal().segment<kDofsPerNode>(static_cast<Eigen::Index>(i) * kDofsPerNode);
        }
    }
    scale = scale.cwiseSqrt();
    return ((a - b).array() / (scale * scale.transpose()).array()).abs().maxCoeff();
}

TEST(Condensation, DenseAndSparseEliminationAgree) {
    sample::Random random(5);
    for (int i = 0; i < 60; ++i) {
        const Extent extent = i % 2 == 0 ? Extent::Flat : Extent::Spatial;
        const Assembly assembly = assemble(random_frame(random, extent));
        const structure::CondensingTask task = structure::condensing_task(assembly, tips());
        const Eigen::MatrixXd dense = structure::condense_dense(task);
        EXPECT_EQ(dense, dense.transpose());
        // Two orders of elimination: rounding, and no more.
        EXPECT_LT(relative_difference(task, dense, structure::condense_sparse(task)), 1e-12) << i;
    }
}

TEST(Condensation, FlatFrameWhoseSectionsCoupleBendingAndMembraneIsCondensedAsOne) {
    Frame frame = sample::flat_wheel();
    for (Beam& beam : frame.beams) {
        beam.section = rectangle_section(0.002, 0.004);
        beam.normal = Eigen::Vector3d(0.3, 0.4, 1.0);
    }
    const Assembly assembly = assemble(frame);
    const structure::CondensingTask task = structure::condensing_task(assembly, tips());
    const Eigen::MatrixXd dense = structure::condense_dense(task);
    EXPECT_GT(dense.row(0).segment<3>(2).cwiseAbs().maxCoeff(), 1e-6 * dense(0, 0));
    EXPECT_LT(relative_difference(task, dense, structure::condense_sparse(task)), 1e-12);
}

TEST(Condensation, DenseAndSparseEliminationRefuseTheSameMechanism) {
    // Node 12 hangs on the wheel by a beam that both of its ends let turn in the plane.
    Frame frame = sample::flat_wheel();
    frame.nodes.emplace_back(0.0, 0.0, 0.0);
    frame.beams.push_back(sample::beam_between(6, 12));
    frame.beams.back().releases = {{0, {{false, false, false, false, false, true}}}};
    const Assembly assembly = assemble(frame);
    const structure::CondensingTask task = structure::condensing_task(assembly, tips());
    for (const auto condense_by : {structure::condense_dense, structure::condense_sparse}) {
        try {
            (void)condense_by(task);
            FAIL();
        } catch (const base::NumericalError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("cannot be condensed"));
            EXPECT_THAT(error.what(),
                        testing::AnyOf(testing::HasSubstr("node 12"), testing::HasSubstr("node 6")));
        }
    }
}

TEST(Condensation, NothingFollowsInAMechanism) {
    for (int i = 0; i < 40; ++i) {  // rounding gives the last pivot either sign
        Frame frame = sample::flat_wheel();
        const double angle = 0.1 + 0.15 * i;
        frame.nodes.push_back(frame.nodes[6] +
                              0.002 * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0));
        frame.beams.push_back(sample::beam_between(6, 12));
        frame.beams.back().releases = {{0, {{false, false, false, false, false, true}}}};
        const Assembly assembly = assemble(frame);
        EXPECT_THROW((void)condense(assembly, tips()), base::NumericalError) << angle;
        EXPECT_THROW((void)following(assembly, tips()), base::NumericalError) << angle;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
