// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/nonlinear/unknowns.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/paths/relaxation.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace fretwork::mechanics {
namespace THIS_TEST {

TEST(Relaxation, FindsNewtonsEquilibrium) {
    Frame bend =
        sample::cantilever({.divisions = 4, .section = {.area = 0.01, .I2 = 1e-6, .I3 = 2e-6, .J = 1e-6}});
    bend.loads.push_back({NodeIndex(1), {0.0, 500.0, 1000.0}});
    Frame pulled = sample::flat_wheel();
    pulled.prescribed.push_back({NodeIndex(4), Dof::uz, 0.005});
    for (const Frame& frame : {sample::star(), bend, pulled}) {
        const Assembly assembly = assemble(frame);
        const double factors[] = {0.5, 1.0};
        const Solution expected = follow_load_path(assembly, factors).back();
        const Solution found = relax(assembly);
        ASSERT_TRUE(found.converged());
        EXPECT_LT((found.displacements - expected.displacements).norm(),
                  1e-6 * expected.displacements.norm());
        EXPECT_EQ(found.stable, expected.stable);
    }
}

// One free displacement that feels its whole mass: where the step back after a peak is not half of the last
// step, the bar swings between rest and twice its elongation for ever.
TEST(Relaxation, PulledBarComesToRestAtItsElongation) {
    for (const double force : {1e-3, -50.0}) {
        Frame frame = sample::cantilever();
        frame.loads.push_back({NodeIndex(1), {force, 0.0, 0.0}});
        const Solution found = relax(assemble(frame));
        ASSERT_TRUE(found.converged());
        EXPECT_LT(found.iterations, 100);
        EXPECT_NEAR(found.displacements(1, 0), force / (1e9 * 0.01), 1e-6 * std::abs(force) / (1e9 * 0.01));
    }
}

// The masses only change the way there. At the scale of patterns the published ones make it longer.
TEST(Relaxation, PublishedMassesFindTheSameEquilibriumMoreSlowly) {
    Frame pulled = sample::flat_wheel();
    pulled.prescribed.push_back({NodeIndex(4), Dof::uz, 0.005});
    for (const Frame& frame : {sample::star(), pulled}) {
        const Assembly assembly = assemble(frame);
        const double factors[] = {0.5, 1.0};
        const Solution expected = follow_load_path(assembly, factors).back();
        const Solution fair = relax(assembly);
        const Solution published = relax(assembly, {.rotational_mass = RotationalMass::Published});
        ASSERT_TRUE(published.converged());
        EXPECT_LT((published.displacements - expected.displacements).norm(),
                  1e-6 * expected.displacements.norm());
        EXPECT_GT(published.iterations, 3 * fair.iterations) << fair.iterations;
    }
}

// The tip swings by a whole turn on its way to rest.
TEST(Relaxation, RotationsAreThoseThatContinueAlongTheBeams) {
    const auto whipped = [](double force) {
        Frame frame;
        frame.nodes = {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}};
        for (const int node : {0, 1}) {
            frame.beams.push_back(sample::beam_between(node, node + 1));
            frame.beams.back().section = rectangle_section(0.01, 0.02);
            frame.beams.back().material = {.young_modulus = 2e9, .poisson_ratio = 0.3, .density = 1000.0};
        }
        sample::clamp(frame, 0);
        frame.loads.push_back({NodeIndex(2), {0.0, 0.0, -force}});
        return frame;
    };
    Frame in_plane = whipped(100.0);  // the vectors of its free nodes are unknowns
    for (const int node : {1, 2})
        in_plane.supports.push_back({NodeIndex(node), {{false, true, false, true, false, true}}});
    for (const Frame& frame : {whipped(100.0), whipped(30.0), in_plane}) {
        const Assembly assembly = assemble(frame);
        const double factors[] = {0.25, 0.5, 1.0};
        const Solution expected = follow_load_path(assembly, factors).back();
        ASSERT_TRUE(expected.converged());
        const Solution found = relax(assembly);
        ASSERT_TRUE(found.converged());
        EXPECT_LT((found.displacements - expected.displacements).cwiseAbs().maxCoeff(), 1e-6);
    }
}

/// A chain of ten bars along x, rolled up about y by 0.9 rad in each.
nonlinear::Configuration rolled(const nonlinear::Unknowns& unknowns) {
    nonlinear::Configuration configuration = unknowns.rest();
    for (std::size_t node = 0; node < configuration.states.size(); ++node)
        configuration.states[node].rotation =
            geometry::exponential(0.9 * static_cast<double>(node) * Eigen::Vector3d::UnitY());
    return configuration;
}

TEST(WholeTurns, ContinueAlongTheElementsFromAHeldNode) {
    Frame chain;
    chain.nodes = {{0, 0, 0}};
    for (int node = 1; node <= 10; ++node) {
        chain.nodes.push_back({0.1 * node, 0, 0});
        chain.beams.push_back(sample::beam_between(node - 1, node));
    }
    Frame held = chain;
    sample::clamp(held, 0);
    const Assembly clamped = assemble(held);
    const nonlinear::Unknowns unknowns(clamped);
    nonlinear::Configuration configuration = rolled(unknowns);
    continue_along_elements(unknowns, configuration);
    for (std::size_t node = 0; node <= 10; ++node)
        EXPECT_NEAR((configuration.rotation_vectors[node] -
                     0.9 * static_cast<double>(node) * Eigen::Vector3d::UnitY())
                        .norm(),
                    0.0, 1e-12)
            << node;

    // No rotation is held: the one node with a support, turned by 4.5 - 2 pi, is where the others begin.
    chain.supports.push_back({NodeIndex(5), sample::kPinned});
    const Assembly pinned = assemble(chain);
    const nonlinear::Unknowns free(pinned);
    configuration = rolled(free);
    continue_along_elements(free, configuration);
    for (std::size_t node = 0; node <= 10; ++node)
        EXPECT_NEAR(configuration.rotation_vectors[node].y(),
                    0.9 * static_cast<double>(node) - 2.0 * std::numbers::pi, 1e-12)
            << node;
}

TEST(Relaxation, SpentIterationsAreReported) {
    const Solution solution = relax(assemble(sample::star()), {.iterations = 3});
    EXPECT_EQ(solution.termination, Termination::IterationsSpent);
}

// The prescribed end lies on the clamped one, where the beam has no direction: no state at the full load is
// finite, and the structure stays at rest.
TEST(Relaxation, DivergesWithFiniteNumbersWhereNoStateIsFinite) {
    for (const bool is_turned_freely : {true, false}) {
        Frame frame = sample::cantilever();
        const bool is_held = !is_turned_freely;
        frame.supports.push_back({NodeIndex(1), {{false, true, true, is_held, is_held, is_held}}});
        frame.prescribed.push_back({NodeIndex(1), Dof::ux, -1.0});
        const Solution found = relax(assemble(frame));
        EXPECT_EQ(found.termination, Termination::Diverged) << is_turned_freely;
        EXPECT_EQ(found.load_factor, 0.0);
        EXPECT_TRUE(found.displacements.isZero(0.0));
        EXPECT_LT(found.reactions.norm(), 1e-6);
        EXPECT_NEAR(found.energy, 0.0, 1e-9);
        EXPECT_EQ(found.residual, 0.0);
    }
}

TEST(Relaxation, BadOptionsAreRefused) {
    EXPECT_THROW(relax(assemble(sample::star()), {.relative_residual = 0.0}), base::InputError);
    EXPECT_THROW(relax(assemble(sample::star()), {.iterations = 0}), base::InputError);
}

/// A bar of four elements, one end clamped and the other twisted, far too stiff to buckle under it.
Frame twisted_bar(double angle) {
    Frame bar =
        sample::cantilever({.divisions = 4, .section = {.area = 0.01, .I2 = 1e-4, .I3 = 1e-4, .J = 2.5e-6}});
    bar.prescribed.push_back({NodeIndex(1), Dof::rx, angle});
    return bar;
}

std::string complaint(const Frame& frame) {
    try {
        relax(assemble(frame), {.iterations = 1});
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

// Uniform torsion: G J / L times the angle, which one the other way round would give another sign.
TEST(Relaxation, TwistJustBelowHalfATurnKeepsItsSense) {
    for (const double angle : {3.1, -3.1}) {
        const Solution found = relax(assemble(twisted_bar(angle)));
        ASSERT_TRUE(found.converged());
        const double torque = 5e8 * 2.5e-6 * angle;
        EXPECT_NEAR(found.reactions(1, 3), torque, 1e-6 * std::abs(torque));
    }
}

TEST(Relaxation, RotationsBeyondHalfATurnAreRefusedByNode) {
    using testing::AllOf;
    using testing::HasSubstr;
    EXPECT_THAT(complaint(twisted_bar(3.2)),
                AllOf(HasSubstr("node 1"), HasSubstr("3.2 rad"), HasSubstr("newton")));
    Frame frame = twisted_bar(2.5);
    frame.prescribed.push_back({NodeIndex(1), Dof::ry, 2.5});
    EXPECT_THAT(complaint(frame), HasSubstr("node 1"));
    frame.prescribed.back().value = 1.0;
    EXPECT_EQ(complaint(frame), "");
    frame.beams[0].divisions = 1;  // both of its ends are prescribed, and each is below pi
    frame.supports = {{NodeIndex(0), DofSet::translations()}};
    frame.prescribed = {{NodeIndex(0), Dof::rx, -2.0}, {NodeIndex(1), Dof::rx, 2.0}};
    EXPECT_THAT(complaint(frame), AllOf(HasSubstr("4 rad against node"), HasSubstr("newton")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
