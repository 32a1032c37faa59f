// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/paths/staged_path.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

namespace fretwork::mechanics {
namespace THIS_TEST {

constexpr double kRise = 0.02;

/// Two strips, pinned 0.4 m apart, that meet 20 mm above: it has two stable states without load.
Frame bistable_arch() {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {0.2, 0, kRise}, {0.4, 0, 0}};
    for (int i = 0; i < 2; ++i) {
        frame.beams.push_back(sample::beam_between(i, i + 1));
        frame.beams.back().section = rectangle_section(0.02, 0.002);  // strips do not buckle sideways
        frame.beams.back().divisions = 6;
    }
    return frame;
}

std::vector<Support> pins() {
    // The feet turn about y only, and the middle stays upright.
    return {{NodeIndex(0), {{true, true, true, true, false, true}}},
            {NodeIndex(2), {{true, true, true, true, false, true}}},
            {NodeIndex(1), {{true, true, false, true, true, true}}}};
}

NodeValues no_loads(const Assembly& assembly) {
    return NodeValues::Zero(std::ssize(assembly.nodes), kDofsPerNode);
}

TEST(StagedPath, AnArchThatIsPushedThroughAndFreedStaysThere) {
    const Assembly assembly = assemble(bistable_arch());
    StagedPath path(assembly);
    const Solution pushed =
        path.advance({pins(), {{NodeIndex(1), Dof::uz, -1.9 * kRise}}, no_loads(assembly)});
    ASSERT_TRUE(pushed.converged());
    EXPECT_NEAR(pushed.displacements(1, 2), -1.9 * kRise, 1e-12);
    const Solution freed = path.advance({pins(), {}, no_loads(assembly)});
    ASSERT_TRUE(freed.converged());
    EXPECT_TRUE(freed.stable);
    EXPECT_LT(freed.displacements(1, 2), -1.4 * kRise) << "it does not come back";
    EXPECT_LT(freed.reactions.leftCols<3>().row(1).norm(), 1e-9);
}

class HeldArch : public testing::TestWithParam<double> {};

/// Let go of, an arch goes downhill. As a load, the force that held it would push some of them over the top,
/// which is where that force changes its sign: near 0.8 of the rise.
TEST_P(HeldArch, GoesDownhillWhereItIsLetGo) {
    const double push = GetParam() * kRise;
    const Assembly assembly = assemble(bistable_arch());
    StagedPath path(assembly);
    const Solution held = path.advance({pins(), {{NodeIndex(1), Dof::uz, -push}}, no_loads(assembly)});
    ASSERT_TRUE(held.converged());
    const Solution freed = path.advance({pins(), {}, no_loads(assembly)});
    ASSERT_TRUE(freed.converged());
    EXPECT_TRUE(freed.stable);
    EXPECT_LT(freed.energy, held.energy);
    if (GetParam() < 0.8) {
        EXPECT_LT(held.reactions(1, 2), 0.0);
        EXPECT_LT(freed.displacements.norm(), 1e-7);
    } else {
        EXPECT_LT(freed.displacements(1, 2), -1.4 * kRise);
    }
}

INSTANTIATE_TEST_SUITE_P(StagedPath, HeldArch, testing::Values(0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 1.2, 1.5, 1.8));

TEST(StagedPath, AStageThatWasStoppedCanBeMadeAgain) {
    const Assembly assembly = assemble(bistable_arch());
    bool stops = false;
    const std::function<bool()> question = [&] { return stops; };
    StagedPath stopped(assembly, {.control = {.question = &question}});
    StagedPath other(assembly);
    const StageTarget push{pins(), {{NodeIndex(1), Dof::uz, -0.9 * kRise}}, no_loads(assembly)};
    const StageTarget release{pins(), {}, no_loads(assembly)};
    ASSERT_TRUE(stopped.advance(push).converged());
    ASSERT_TRUE(other.advance(push).converged());
    stops = true;
    EXPECT_THROW((void)stopped.advance(release), base::Stopped);
    stops = false;
    const Solution again = stopped.advance(release);
    const Solution expected = other.advance(release);
    ASSERT_TRUE(again.converged());
    EXPECT_EQ((again.displacements - expected.displacements).norm(), 0.0) << "as without the stop";
    EXPECT_EQ(again.stability_losses.size(), expected.stability_losses.size());
}

TEST(StagedPath, WhatIsKeptBearsTheLoadThatPressedIt) {
    const Assembly assembly = assemble(bistable_arch());
    StagedPath path(assembly);
    NodeValues loads = no_loads(assembly);
    loads(1, 2) = -0.2;
    const Solution pressed = path.advance({pins(), {}, loads});
    ASSERT_TRUE(pressed.converged());
    const double there = pressed.displacements(1, 2);
    const Solution kept = path.advance({pins(), {{NodeIndex(1), Dof::uz, there}}, no_loads(assembly)});
    ASSERT_TRUE(kept.converged());
    EXPECT_EQ(kept.displacements(1, 2), there);
    EXPECT_NEAR(kept.reactions(1, 2), -0.2, 1e-6);
    const Solution freed = path.advance({pins(), {}, no_loads(assembly)});
    ASSERT_TRUE(freed.converged());
    EXPECT_LT(freed.displacements.norm(), 1e-7) << "within the elastic range it comes back to rest";
}

/// Elements of 1/200 of a cantilever under ten times P L^2 / E I: in 1/2048 of the stage its tip moves by a
/// third of an element, which is no jump.
TEST(StagedPath, AStageBeginsAsSlowlyAsALargeLoadNeeds) {
    Frame frame = sample::cantilever({.divisions = 200});
    const Beam& beam = frame.beams.front();
    const double length = (frame.nodes.back() - frame.nodes.front()).norm();
    const double stiffness = beam.material.young_modulus * beam.section.I2;
    const Assembly assembly = assemble(frame);
    NodeValues loads = no_loads(assembly);
    loads(1, 2) = -10.0 * stiffness / (length * length);
    StagedPath path(assembly);
    const Solution staged = path.advance({frame.supports, {}, loads});
    ASSERT_TRUE(staged.converged());
    EXPECT_TRUE(staged.stability_losses.empty());
    Assembly loaded = assembly;
    loaded.loads = loads;
    const Solution whole = follow_load_path(loaded, std::vector{1.0}).back();
    ASSERT_TRUE(whole.converged());
    EXPECT_LT((staged.displacements - whole.displacements).norm(), 1e-8 * whole.displacements.norm());
}

TEST(StagedPath, OneStageIsTheLoadPath) {
    const Frame star = sample::star();
    const Assembly assembly = assemble(star);
    StagedPath path(assembly);
    const Solution staged = path.advance({star.supports, {}, assembly.loads});
    const Solution whole = follow_load_path(assembly, std::vector{1.0}).back();
    ASSERT_TRUE(staged.converged());
    EXPECT_LT((staged.displacements - whole.displacements).norm(), 1e-8 * whole.displacements.norm());
}

TEST(StagedPath, TwoHalvesAreOneStage) {
    const Frame star = sample::star();
    const Assembly assembly = assemble(star);
    StagedPath path(assembly);
    ASSERT_TRUE(path.advance({star.supports, {}, 0.5 * assembly.loads}).converged());
    const Solution staged = path.advance({star.supports, {}, assembly.loads});
    ASSERT_TRUE(staged.converged());
    const Solution whole = follow_load_path(assembly, std::vector{1.0}).back();
    EXPECT_LT((staged.displacements - whole.displacements).norm(), 1e-8 * whole.displacements.norm());
}

/// A strip of 20 elements, clamped at its ends, that is pushed together.
Frame column() {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {0.2, 0, 0}, {0.4, 0, 0}};
    for (int i = 0; i < 2; ++i) {
        frame.beams.push_back(sample::beam_between(i, i + 1));
        frame.beams.back().section = rectangle_section(0.02, 0.002);
        frame.beams.back().divisions = 10;
    }
    sample::clamp(frame, 0);
    frame.supports.push_back({NodeIndex(2), {{false, true, true, true, true, true}}});
    return frame;
}

/// 4 pi^2 E I / L^2, N.
double euler_load_of_the_column() {
    const Beam beam = column().beams.front();
    const double pi = std::numbers::pi;
    const double stiffness = beam.material.young_modulus * std::min(beam.section.I2, beam.section.I3);
    return 4.0 * pi * pi * stiffness / (0.4 * 0.4);
}

class ImperfectColumn : public testing::TestWithParam<std::tuple<double, double>> {};

/// Its path is smooth, though it nearly branches: nothing pushes it to the other side.
TEST_P(ImperfectColumn, BendsInAStageToTheSideOfItsLoad) {
    const auto [push, share] = GetParam();
    Frame frame = column();
    frame.prescribed.push_back({NodeIndex(2), Dof::ux, -push});
    frame.loads.push_back({NodeIndex(1), {0, 0, share * euler_load_of_the_column()}, {0, 0, 0}});
    const Assembly assembly = assemble(frame);
    StagedPath path(assembly);
    const Solution staged = path.advance({frame.supports, frame.prescribed, assembly.loads});
    ASSERT_TRUE(staged.converged());
    EXPECT_TRUE(staged.stable);
    EXPECT_TRUE(staged.stability_losses.empty());
    EXPECT_GT(staged.displacements(1, 2) * share, 0.0);
    const Solution whole = follow_load_path(assembly, std::vector{1.0}).back();
    EXPECT_LT((staged.displacements - whole.displacements).norm(), 1e-8 * whole.displacements.norm());
}

INSTANTIATE_TEST_SUITE_P(StagedPath, ImperfectColumn,
                         testing::Combine(testing::Values(0.001, 0.02, 0.1),
                                          testing::Values(0.02, -0.004, 0.001)));

/// Held in the middle, a column bears more than Euler's load; freed, it buckles before the load changes.
TEST(StagedPath, AColumnThatIsFreedBucklesAtTheBeginningOfItsStage) {
    const Frame frame = column();
    const Assembly assembly = assemble(frame);
    const Beam& beam = frame.beams.front();
    const double push =
        1.5 * euler_load_of_the_column() * 0.4 / (beam.material.young_modulus * beam.section.area);
    const PrescribedDisplacement pushed{NodeIndex(2), Dof::ux, -push};
    StagedPath path(assembly);
    const Solution held =
        path.advance({frame.supports, {pushed, {NodeIndex(1), Dof::uz, 0.0}}, no_loads(assembly)});
    ASSERT_TRUE(held.converged());
    EXPECT_TRUE(held.stability_losses.empty());
    const Solution freed = path.advance({frame.supports, {pushed}, no_loads(assembly)});
    ASSERT_TRUE(freed.converged());
    EXPECT_TRUE(freed.stable);
    ASSERT_EQ(freed.stability_losses.size(), 1U);
    EXPECT_EQ(freed.stability_losses[0].load_factor, 0.0);
    EXPECT_TRUE(freed.stability_losses[0].pushed);
    EXPECT_EQ(freed.stability_losses[0].node, NodeIndex(1));
    Frame whole = frame;
    whole.prescribed = {pushed};
    const Solution stable =
        follow_load_path(assemble(whole), std::vector{1.0}, {.branch = Branch::Stable}).back();
    ASSERT_TRUE(stable.converged());
    EXPECT_NEAR(std::abs(freed.displacements(1, 2)), std::abs(stable.displacements(1, 2)),
                1e-7 * std::abs(stable.displacements(1, 2)));
}

/// Its rates are rounding, of which nothing can be said.
TEST(StagedPath, AStageThatChangesNothingStaysWhereItIs) {
    const Frame star = sample::star();
    const Assembly assembly = assemble(star);
    StagedPath path(assembly);
    const std::vector<PrescribedDisplacement> turned = {{NodeIndex(0), Dof::ry, -0.00036944951782504065}};
    const Solution before = path.advance({star.supports, turned, assembly.loads});
    ASSERT_TRUE(before.converged());
    std::vector<PrescribedDisplacement> kept = turned;
    for (int d = 0; d < 3; ++d)
        kept.push_back({NodeIndex(0), static_cast<Dof>(d), before.displacements(0, d)});
    for (int i = 0; i < 3; ++i) {
        const Solution after = path.advance({star.supports, kept, assembly.loads});
        ASSERT_TRUE(after.converged());
        EXPECT_LT((after.displacements - before.displacements).norm(), 1e-15);
    }
}

TEST(StagedPath, WhatIsUnloadedIsAtRestWithoutAResidual) {
    const Frame star = sample::star();
    const Assembly assembly = assemble(star);
    StagedPath path(assembly);
    ASSERT_TRUE(path.advance({star.supports, {{NodeIndex(0), Dof::ux, 1e-3}}, assembly.loads}).converged());
    ASSERT_TRUE(path.advance({star.supports, {}, assembly.loads}).converged());
    const Solution unloaded = path.advance({star.supports, {}, no_loads(assembly)});
    ASSERT_TRUE(unloaded.converged());
    EXPECT_EQ(unloaded.residual, 0.0) << "all forces are rounding";
    EXPECT_LT(unloaded.displacements.norm(), 1e-12);
}

/// The moment that has held one component of a rotation has all three.
TEST(StagedPath, ARotationThatIsFreedComesBack) {
    const Frame star = sample::star();
    const Assembly assembly = assemble(star);
    StagedPath path(assembly);
    const Solution turned = path.advance({star.supports, {{NodeIndex(0), Dof::rx, 0.3}}, assembly.loads});
    ASSERT_TRUE(turned.converged());
    EXPECT_NEAR(turned.displacements(0, 3), 0.3, 1e-15);
    const Solution freed = path.advance({star.supports, {}, assembly.loads});
    ASSERT_TRUE(freed.converged());
    const Solution whole = follow_load_path(assembly, std::vector{1.0}).back();
    EXPECT_LT((freed.displacements - whole.displacements).norm(), 1e-8 * whole.displacements.norm());
}

/// The moment that has held the rotation is gone at the end.
TEST(StagedPath, StabilityIsThatOfTheTangentWhereNoMomentActs) {
    Frame star = sample::star();
    star.loads[0].moment.setZero();
    const Assembly assembly = assemble(star);
    StagedPath path(assembly);
    ASSERT_TRUE(path.advance({star.supports, {{NodeIndex(0), Dof::rx, 0.3}}, assembly.loads}).converged());
    const Solution freed = path.advance({star.supports, {}, assembly.loads});
    ASSERT_TRUE(freed.converged());
    EXPECT_EQ(freed.stability, StabilityTest::Tangent);
}

TEST(StagedPath, SnapsAreCrossedOnRequestAndTold) {
    Frame shallow = bistable_arch();
    shallow.nodes[1].z() = 0.006;
    const Assembly assembly = assemble(shallow);
    const std::vector<Support> clamps = {{NodeIndex(0), DofSet::all()},
                                         {NodeIndex(2), DofSet::all()},
                                         {NodeIndex(1), {{true, true, false, true, true, true}}}};
    NodeValues loads = no_loads(assembly);
    loads(1, 2) = -3.0;
    StagedPath stopping(assembly);
    const Solution stopped = stopping.advance({clamps, {}, loads});
    EXPECT_EQ(stopped.termination, Termination::LimitLoad);
    StagedPath crossing(assembly, {.branch = Branch::Snapping});
    const Solution snapped = crossing.advance({clamps, {}, loads});
    ASSERT_TRUE(snapped.converged());
    EXPECT_TRUE(snapped.stable);
    EXPECT_LT(snapped.displacements(1, 2), -0.012);
    ASSERT_EQ(snapped.stability_losses.size(), 1U);
    EXPECT_EQ(snapped.stability_losses[0].node, NodeIndex(1));
    EXPECT_NEAR(snapped.stability_losses[0].load_factor, stopped.load_factor, 5e-3);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
