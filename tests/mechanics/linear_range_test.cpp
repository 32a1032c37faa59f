// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/paths/linear_range.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace THIS_TEST {

/// A slender strip of 0.4 m with 20 elements, clamped at its left end.
Frame strip(double force) {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {0.2, 0, 0}, {0.4, 0, 0}};
    for (int i = 0; i < 2; ++i) {
        frame.beams.push_back(sample::beam_between(i, i + 1));
        frame.beams.back().divisions = 10;
    }
    sample::clamp(frame, 0);
    frame.loads.push_back({NodeIndex(1), {0, 0, force}});
    return frame;
}
Frame pinned_strip(double force) {
    Frame frame = strip(force);
    frame.supports.push_back({NodeIndex(2), sample::kPinned});
    return frame;
}

/// The largest error of the linear solution as a share of the largest true displacement.
double true_error(const Assembly& assembly) {
    const Solution linear = solve_linear(assembly);
    const Solution full = follow_load_path(assembly, std::vector{1.0}).back();
    EXPECT_TRUE(full.converged());
    const auto size = [](const NodeValues& rows) { return rows.leftCols<3>().rowwise().norm().maxCoeff(); };
    return size(linear.displacements - full.displacements) / size(full.displacements);
}

TEST(LinearRange, EstimateIsWithinAFactorOfTwoOfTheTrueError) {
    for (const double force : {0.005, 0.02, 0.05}) {
        const Assembly assembly = assemble(strip(force));
        const double estimate = linear_range(assembly).error;
        const double truth = true_error(assembly);
        EXPECT_GT(estimate, 0.5 * truth) << force;
        EXPECT_LT(estimate, 2.0 * truth) << force;
    }
    for (const double force : {0.01, 0.1, 0.5, 2.0}) {
        const Assembly assembly = assemble(pinned_strip(force));
        const double estimate = linear_range(assembly).error;
        const double truth = true_error(assembly);
        EXPECT_GT(estimate, 0.5 * truth) << force;
        EXPECT_LT(estimate, 2.0 * truth) << force;
    }
}

TEST(LinearRange, SmallLoadsAreWellWithinIt) {
    EXPECT_LT(linear_range(assemble(strip(1e-5))).error, 1e-3);
    EXPECT_FALSE(linear_range(assemble(strip(1e-5))).loses_stability);
    EXPECT_EQ(linear_range(assemble(strip(0.0))).error, 0.0);
}

TEST(LinearRange, AColumnBeyondItsBucklingLoadHasLostItsStability) {
    // Euler's load of a cantilever, pi^2 E I / (4 l^2), with E I = 1e9 * 2^4/12 e-12.
    const double critical = 9.8696 * 1e9 * 1.3333e-12 / (4 * 0.16);
    for (const double factor : {0.9, 1.1}) {
        Frame frame = strip(0.0);
        frame.loads = {{NodeIndex(2), {-factor * critical, 0, 0}}};
        EXPECT_EQ(linear_range(assemble(frame)).loses_stability, factor > 1.0) << factor;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
