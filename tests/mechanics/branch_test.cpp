// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "verification/benchmark_frames.hpp"

#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace fretwork::mechanics {
namespace THIS_TEST {

constexpr double kPi = std::numbers::pi;

using verification::euler_column;

// The elastica in elliptic integrals (Timoshenko and Gere, Theory of Elastic Stability, 2.7): with the tip's
// angle a and k = sin(a / 2), the load is (2 K(k) / pi)^2 of Euler's, the tip stands 2 E / K - 1 above the
// foot and 2 k / K beside it.
TEST(Branch, StableBranchOfColumnMatchesElastica) {
    std::vector<double> angles;
    std::vector<double> factors;
    for (const double degrees : {40.0, 60.0, 90.0, 120.0}) {
        angles.push_back(degrees * kPi / 180.0);
        const double k = std::comp_ellint_1(std::sin(angles.back() / 2.0));
        factors.push_back(std::pow(2.0 * k / kPi, 2));
    }
    const auto path = follow_load_path(assemble(euler_column(20)), factors, {.branch = Branch::Stable});
    for (std::size_t i = 0; i < path.size(); ++i) {
        ASSERT_TRUE(path[i].converged());
        EXPECT_TRUE(path[i].stable);
        const double k = std::sin(angles[i] / 2.0);
        const double first = std::comp_ellint_1(k);
        EXPECT_NEAR(1.0 + path[i].displacements(1, 0), 2.0 * std::comp_ellint_2(k) / first - 1.0, 2e-5);
        EXPECT_NEAR(path[i].displacements(1, 2), 2.0 * k / first, 2e-5);
        EXPECT_NEAR(path[i].displacements(1, 1), 0.0, 1e-9);
        EXPECT_NEAR(-path[i].displacements(1, 4), angles[i], 4e-5);
    }
    ASSERT_EQ(path[0].stability_losses.size(), 1u);
    EXPECT_TRUE(path[0].stability_losses[0].pushed);
    // Axial stiffness is high, but not infinite: the column is a little shorter when it buckles.
    EXPECT_NEAR(path[0].stability_losses[0].load_factor, 1.0, 1e-5);
    EXPECT_EQ(path[0].stability_losses[0].node, NodeIndex(1));
    EXPECT_TRUE(path[1].stability_losses.empty());
}

// A column that bends equally about both axes buckles in any direction: all those shapes are equilibria, and
// which of them rounding calls stable must not matter.
TEST(Branch, StableBranchOfSquareColumnMatchesElasticaInAnyDirection) {
    Frame frame = euler_column(20);
    frame.beams[0].section.I3 = frame.beams[0].section.I2;
    std::vector<double> angles;
    std::vector<double> factors;
    for (const double degrees : {20.0, 60.0, 90.0, 120.0}) {
        angles.push_back(degrees * kPi / 180.0);
        factors.push_back(std::pow(2.0 * std::comp_ellint_1(std::sin(angles.back() / 2.0)) / kPi, 2));
    }
    for (const int steps : {1, 4}) {
        const auto path =
            follow_load_path(assemble(frame), std::span(factors).last(static_cast<std::size_t>(steps)),
                             {.branch = Branch::Stable});
        for (std::size_t i = 0; i < path.size(); ++i) {
            ASSERT_TRUE(path[i].converged()) << steps << " " << i << " " << path[i].load_factor;
            EXPECT_TRUE(path[i].stable);
            const double k = std::sin(angles[angles.size() - path.size() + i] / 2.0);
            const double first = std::comp_ellint_1(k);
            EXPECT_NEAR(1.0 + path[i].displacements(1, 0), 2.0 * std::comp_ellint_2(k) / first - 1.0, 2e-5);
            EXPECT_NEAR(path[i].displacements.row(1).segment<2>(1).norm(), 2.0 * k / first, 2e-5);
            EXPECT_EQ(path[i].stability_losses.size(), i == 0 ? 1u : 0u);
        }
    }
}

// Both ends are held, and only inner nodes of the beam move when it buckles.
TEST(Branch, CriticalModeInsideBeamsIsReportedAtNearestNode) {
    Frame frame = euler_column(20);
    frame.loads.clear();
    frame.supports.push_back({NodeIndex(1), {{false, true, true, true, true, true}}});
    frame.prescribed.push_back({NodeIndex(1), Dof::ux, -1e-5});
    const double factors[] = {0.5, 1.0};
    const auto path = follow_load_path(assemble(frame), factors, {.locate_critical_loads = true});
    ASSERT_EQ(path[0].stability_losses.size(), 1u);
    const StabilityLoss& loss = path[0].stability_losses[0];
    // Shortened until E A u / L is Euler's load of a clamped column, 4 pi^2 E I / L^2.
    EXPECT_NEAR(1e-5 * loss.load_factor, 4.0 * kPi * kPi * 1e-6 / 10.0, 1e-8);
    EXPECT_GE(loss.node.value, 0);
    EXPECT_LT(loss.node.value, 2);
    EXPECT_EQ(loss.dof, Dof::uz);
}

TEST(Branch, PrimaryPathContinuesPastReportedCriticalLoad) {
    const double factors[] = {0.5, 1.5};
    const Assembly assembly = assemble(euler_column(8));
    const auto path = follow_load_path(assembly, factors, {.locate_critical_loads = true});
    EXPECT_TRUE(path[0].stability_losses.empty());
    ASSERT_EQ(path[1].stability_losses.size(), 1u);
    const StabilityLoss& loss = path[1].stability_losses[0];
    EXPECT_FALSE(loss.pushed);
    EXPECT_FALSE(path[1].stable);
    EXPECT_NEAR(path[1].displacements.leftCols<3>().rightCols<2>().norm(), 0.0, 1e-12);
    EXPECT_NEAR(loss.load_factor, buckling_modes(assembly, 1)[0].value, 1e-5);
    // The describing data belong to the equilibrium itself, not to those that located the critical load.
    EXPECT_LE(path[1].residual, 1e-9);
    EXPECT_NEAR(path[1].reactions(0, 0), 1.5 * kPi * kPi / 4.0 * 1e3, 1e-6);
}

/// Von Mises' truss with an apex that two more bars hold sideways, under 42 N. It leaves its plane at 37.649
/// N; in its plane, the limit load is 38.114 N.
Frame truss_that_leaves_its_plane() {
    const DofSet rotations{{false, false, false, true, true, true}};
    Frame frame;
    frame.nodes = {{-1, 0, 0}, {0, 0, 0.1}, {1, 0, 0}, {0, 2, 0.1}, {0, -2, 0.1}};
    for (const int foot : {0, 2, 3, 4}) {
        Beam bar = sample::beam_between(foot, 1);
        bar.section = {.area = foot < 3 ? 1e-4 : 6e-7, .I2 = 1e-6, .I3 = 1e-6, .J = 1e-6};
        bar.releases = {{0, rotations}, {1, rotations}};
        frame.beams.push_back(bar);
        sample::clamp(frame, foot);
    }
    frame.supports.push_back({NodeIndex(1), {{true, false, false, true, true, true}}});
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, -42.0}});
    return frame;
}

// A long step passes both the loss of stability and the limit.
TEST(Branch, LossOfStabilityJustBeforeALimitIsFoundInStepsOfAnyLength) {
    const Assembly truss = assemble(truss_that_leaves_its_plane());
    for (const int steps : {1, 2, 10}) {
        for (const Branch branch : {Branch::Primary, Branch::Stable, Branch::Snapping}) {
            const Solution end = end_of_path(follow_load_path(
                truss, even_load_factors(steps), {.branch = branch, .locate_critical_loads = true}));
            ASSERT_FALSE(end.stability_losses.empty()) << steps;
            const StabilityLoss& first = end.stability_losses.front();
            EXPECT_NEAR(first.load_factor, 37.649 / 42.0, 1e-4) << steps;
            EXPECT_EQ(first.node, NodeIndex(1)) << steps;
            EXPECT_EQ(first.dof, Dof::uy) << steps;
            EXPECT_EQ(first.pushed, branch != Branch::Primary) << steps;
        }
    }
}

TEST(Branch, StablePathIsNotPushed) {
    const Assembly assembly = assemble(sample::star());
    const double factors[] = {0.5, 1.0};
    const auto plain = follow_load_path(assembly, factors);
    const auto pushed = follow_load_path(assembly, factors, {.branch = Branch::Stable});
    for (std::size_t i = 0; i < 2; ++i) {
        // The plain path goes in longer strides: what differs is what the residual's tolerance leaves.
        EXPECT_LT((plain[i].displacements - pushed[i].displacements).norm(),
                  1e-8 * pushed[i].displacements.norm());
        EXPECT_TRUE(pushed[i].stability_losses.empty());
    }
}

// A flat wheel pushed in its plane leaves the plane.
TEST(Branch, FlatWheelBucklesOutOfPlane) {
    Frame frame = sample::flat_wheel();
    frame.loads.push_back({NodeIndex(3), {4.0, 0.0, 0.0}});
    frame.loads.push_back({NodeIndex(4), {4.0, 0.0, 0.0}});
    const Assembly assembly = assemble(frame);
    const double factors[] = {0.25, 0.5, 0.75, 1.0};
    const auto flat = follow_load_path(assembly, factors);
    const auto buckled = follow_load_path(assembly, factors, {.branch = Branch::Stable});
    ASSERT_TRUE(flat.back().converged());
    ASSERT_TRUE(buckled.back().converged());
    EXPECT_FALSE(flat.back().stable);
    EXPECT_EQ(flat.back().displacements.col(2).norm(), 0.0);
    EXPECT_TRUE(buckled.back().stable);
    EXPECT_GT(buckled.back().displacements.col(2).norm(), 0.005);
    EXPECT_LE(buckled.back().residual, 1e-9);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
