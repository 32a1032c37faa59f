// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/equilibrium.hpp>
#include <fretwork/mechanics/relaxation.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace {

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
TEST(Relaxation, ABarAlongAnAxisComesToRestAtItsElongation) {
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

TEST(Relaxation, SpentIterationsAreReported) {
    const Solution solution = relax(assemble(sample::star()), {.iterations = 3});
    EXPECT_EQ(solution.termination, Termination::IterationsSpent);
}

TEST(Relaxation, BadOptionsAreRefused) {
    EXPECT_THROW(relax(assemble(sample::star()), {.relative_residual = 0.0}), base::InputError);
    EXPECT_THROW(relax(assemble(sample::star()), {.iterations = 0}), base::InputError);
}

}  // namespace
}  // namespace fretwork::mechanics
