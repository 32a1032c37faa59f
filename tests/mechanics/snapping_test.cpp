// SPDX-License-Identifier: GPL-3.0-or-later
// Shallow structures of which the load has a limit: beyond it they snap through.
#include "sample.hpp"

#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/paths/relaxation.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace fretwork::mechanics {
namespace THIS_TEST {

/// A strip, 20 mm wide and 2 mm thick, that bends out of the plane of its supports.
Beam strip_between(int from, int to) {
    Beam beam = sample::beam_between(from, to);
    beam.section = rectangle_section(0.02, 0.002);
    beam.divisions = 8;
    return beam;
}

/// Two strips, clamped 0.4 m apart, that meet 6 mm above; pressed down where they meet, and held upright
/// there.
Frame shallow_arch() {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {0.2, 0, 0.006}, {0.4, 0, 0}};
    for (int i = 0; i < 2; ++i) frame.beams.push_back(strip_between(i, i + 1));
    sample::clamp(frame, 0);
    sample::clamp(frame, 2);
    frame.supports.push_back({NodeIndex(1), {{false, true, false, true, true, true}}});
    frame.loads.push_back({NodeIndex(1), {0, 0, -3.0}});
    return frame;
}

/// A star of six strips whose middle stands 8 mm above its clamped tips; pressed down there, and held
/// upright.
Frame shallow_star() {
    Frame frame;
    frame.nodes = {{0, 0, 0.008}};
    for (int i = 0; i < 6; ++i) {
        const double angle = std::numbers::pi / 3.0 * i;
        frame.nodes.emplace_back(0.2 * std::cos(angle), 0.2 * std::sin(angle), 0.0);
        frame.beams.push_back(strip_between(0, i + 1));
        sample::clamp(frame, i + 1);
    }
    frame.supports.push_back({NodeIndex(0), {{true, true, false, true, true, true}}});
    frame.loads.push_back({NodeIndex(0), {0, 0, -15.0}});
    return frame;
}

class Snapping : public testing::TestWithParam<Frame (*)()> {};

TEST_P(Snapping, PathThatEndsAtALimitLoadReachesTheFullLoadBeyondIt) {
    const Assembly assembly = assemble(GetParam()());
    const Solution stopped = follow_load_path(assembly, std::vector{1.0}).back();
    ASSERT_EQ(stopped.termination, Termination::LimitLoad);
    ASSERT_LT(stopped.load_factor, 0.95);
    const Solution snapped =
        follow_load_path(assembly, std::vector{1.0}, {.branch = Branch::Snapping}).back();
    ASSERT_TRUE(snapped.converged());
    EXPECT_TRUE(snapped.stable);
    EXPECT_EQ(snapped.load_factor, 1.0);
    ASSERT_FALSE(snapped.stability_losses.empty());
    const StabilityLoss& jump = snapped.stability_losses.back();
    // The primary path goes on a little beyond the limit where it turns unstable on the way.
    EXPECT_NEAR(jump.load_factor, stopped.load_factor, 5e-3);
    EXPECT_TRUE(jump.pushed);
    EXPECT_EQ(jump.dof, Dof::uz);
    // A damped motion from rest under the full load passes the limit with its own inertia.
    const Solution damped = relax(assembly);
    ASSERT_TRUE(damped.converged());
    const NodeValues difference = snapped.displacements - damped.displacements;
    EXPECT_LT(difference.leftCols<3>().norm(), 1e-5 * damped.displacements.leftCols<3>().norm());
}

TEST_P(Snapping, EquilibriaBeforeTheLimitAreThoseOfThePrimaryPath) {
    const Assembly assembly = assemble(GetParam()());
    const double limit = follow_load_path(assembly, std::vector{1.0}).back().load_factor;
    const std::vector factors{0.3 * limit, 0.6 * limit};
    const auto primary = follow_load_path(assembly, factors);
    const auto snapping = follow_load_path(assembly, factors, {.branch = Branch::Snapping});
    for (std::size_t i = 0; i < factors.size(); ++i)
        EXPECT_LT((primary[i].displacements - snapping[i].displacements).norm(),
                  1e-6 * primary[i].displacements.norm());
}

INSTANTIATE_TEST_SUITE_P(Shallow, Snapping, testing::Values(shallow_arch, shallow_star));

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
