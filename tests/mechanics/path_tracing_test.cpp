// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "verification/benchmark_frames.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/paths/path_tracing.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace fretwork::mechanics {
namespace THIS_TEST {

/// The load factor of the first maximum along a path, by the parabola through the three points around it.
double first_limit(const std::vector<Solution>& path) {
    for (std::size_t k = 1; k + 1 < path.size(); ++k) {
        const double a = path[k - 1].load_factor;
        const double b = path[k].load_factor;
        const double c = path[k + 1].load_factor;
        if (b > a && b > c) return b + (c - a) * (c - a) / (8.0 * (2.0 * b - a - c));
    }
    return 0.0;
}

// Lee, Manuel and Rossow (1968): legs of 120, hinged at both feet, the load at a fifth of the upper leg. The
// first limit load is about 18,557 N in units where E = 7.2e6, A = 6, I = 2.
TEST(PathTracing, PassesTheLimitLoadOfLeesFrame) {
    const auto path = trace_path(assemble(verification::lee_frame()),
                                 {.largest_load_factor = 2.0, .largest_arc = 0.6, .steps = 150});
    EXPECT_NEAR(first_limit(path), 1.0, 2e-3);
    EXPECT_TRUE(std::any_of(path.begin(), path.end(), [](const Solution& s) { return !s.stable; }));
    const auto lowest = std::min_element(path.begin(), path.end(), [](const Solution& a, const Solution& b) {
        return a.load_factor < b.load_factor;
    });
    EXPECT_LT(lowest->load_factor, 0.0);  // the frame snaps back below zero load
}

// Williams (1964): a toggle of two flat clamped bars; the frame's load is the limit load of the
// extensible elastica. The peak is that of a parabola through three points of the path.
TEST(PathTracing, PassesTheLimitLoadOfWilliamsToggle) {
    const auto path = trace_path(assemble(verification::williams_toggle()),
                                 {.largest_load_factor = 1.5, .largest_arc = 0.05, .steps = 400});
    EXPECT_NEAR(first_limit(path), 1.0, 1e-4);
    EXPECT_GT(path.back().load_factor, 1.5);  // through the snap, and stiff again
    EXPECT_TRUE(path.back().stable);
}

TEST(PathTracing, AgreesWithLoadPathBelowLimitLoad) {
    const Assembly assembly = assemble(sample::star());
    const auto traced = trace_path(assembly);
    std::vector<double> factors;
    for (const Solution& solution : traced) factors.push_back(solution.load_factor);
    const auto path = follow_load_path(assembly, factors);
    ASSERT_EQ(path.size(), traced.size());
    for (std::size_t k = 0; k < path.size(); ++k)
        EXPECT_LT((path[k].displacements - traced[k].displacements).norm(),
                  1e-7 * path[k].displacements.norm());
}

/// Beyond half a turn, an element would take its twist for one in the opposite sense.
TEST(PathTracing, EndsWhereAnElementIsTwistedByHalfATurn) {
    constexpr double kAngle = 7.0;
    constexpr double kTorquePerRadian = 0.5 * 1e9 * 2.5e-6;
    Frame frame = sample::cantilever({.divisions = 2});
    frame.supports.push_back({NodeIndex(1), {{false, true, true, false, true, true}}});
    frame.prescribed.push_back({NodeIndex(1), Dof::rx, kAngle});
    const auto path = trace_path(assemble(frame));
    EXPECT_FALSE(path.back().converged());
    EXPECT_GT(path.back().load_factor, 0.7);
    EXPECT_LT(path.back().load_factor, 2.0 * std::numbers::pi / kAngle);
    for (const Solution& solution : path)
        EXPECT_NEAR(solution.reactions(1, 3), kTorquePerRadian * kAngle * solution.load_factor,
                    1e-6 * kTorquePerRadian);
}

TEST(PathTracing, BadOptionsAreRefused) {
    const Assembly assembly = assemble(sample::star());
    EXPECT_THROW(trace_path(assembly, {.first_load_step = 0.0}), base::InputError);
    EXPECT_THROW(trace_path(assembly, {.steps = 0}), base::InputError);
    EXPECT_THROW(trace_path(assembly, {.largest_cut_back = -1}), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
