// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/path_tracing.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace fretwork::mechanics {
namespace {

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

/// Keep a frame in the plane y = 0.
void hold_in_plane(Frame& frame) {
    for (std::size_t i = 0; i < frame.nodes.size(); ++i)
        frame.supports.push_back({NodeIndex(i), {{false, true, false, true, false, true}}});
}

void add_leg(Frame& frame, const Eigen::Vector3d& end, int beams) {
    const Beam like = frame.beams.empty() ? Beam{} : frame.beams.back();
    const Eigen::Vector3d start = frame.nodes.back();
    for (int k = 1; k <= beams; ++k) {
        frame.nodes.push_back(start + (end - start) * k / beams);
        Beam beam = like;
        const int last = static_cast<int>(frame.nodes.size()) - 1;
        beam.nodes = {NodeIndex(last - 1), NodeIndex(last)};
        frame.beams.push_back(beam);
    }
}

// Lee, Manuel and Rossow (1968): legs of 120, hinged at both feet, the load at a fifth of the upper leg. The
// first limit load is about 18,557 N in units where E = 7.2e6, A = 6, I = 2.
TEST(PathTracing, PassesTheLimitLoadOfLeesFrame) {
    Frame frame;
    frame.nodes = {{0, 0, 0}};
    frame.beams.push_back({.nodes = {},
                           .section = {.area = 6.0, .I2 = 2.0, .I3 = 2.0, .J = 4.0},
                           .material = {.young_modulus = 7.2e6, .poisson_ratio = 0.3}});
    add_leg(frame, {0, 0, 120}, 8);
    add_leg(frame, {24, 0, 120}, 2);
    const int loaded = static_cast<int>(frame.nodes.size()) - 1;
    add_leg(frame, {120, 0, 120}, 8);
    frame.beams.erase(frame.beams.begin());
    hold_in_plane(frame);
    for (const int foot : {0, static_cast<int>(frame.nodes.size()) - 1})
        frame.supports.push_back({NodeIndex(foot), DofSet::translations()});
    frame.loads.push_back({NodeIndex(loaded), {0.0, 0.0, -18557.0}});
    const auto path =
        trace_path(assemble(frame), {.largest_load_factor = 2.0, .largest_arc = 0.6, .steps = 150});
    EXPECT_NEAR(first_limit(path), 1.0, 2e-3);
    EXPECT_TRUE(std::any_of(path.begin(), path.end(), [](const Solution& s) { return !s.stable; }));
    const auto lowest = std::min_element(path.begin(), path.end(), [](const Solution& a, const Solution& b) {
        return a.load_factor < b.load_factor;
    });
    EXPECT_LT(lowest->load_factor, 0.0);  // the frame snaps back below zero load
}

// Williams (1964): a toggle of two flat clamped bars; limit load about 33.98 lb in inches and pounds.
TEST(PathTracing, PassesTheLimitLoadOfWilliamsToggle) {
    Frame frame;
    frame.nodes = {{-12.943, 0, 0}};
    const double width = 0.753;
    const double height = 0.243;
    frame.beams.push_back({.nodes = {},
                           .section = {.area = width * height,
                                       .I2 = width * std::pow(height, 3) / 12.0,
                                       .I3 = height * std::pow(width, 3) / 12.0,
                                       .J = 0.003},
                           .material = {.young_modulus = 1.03e7, .poisson_ratio = 0.3}});
    add_leg(frame, {0, 0, 0.386}, 4);
    add_leg(frame, {12.943, 0, 0}, 4);
    frame.beams.erase(frame.beams.begin());
    hold_in_plane(frame);
    sample::clamp(frame, 0);
    sample::clamp(frame, 8);
    frame.loads.push_back({NodeIndex(4), {0.0, 0.0, -33.98}});
    const auto path =
        trace_path(assemble(frame), {.largest_load_factor = 1.5, .largest_arc = 0.03, .steps = 200});
    EXPECT_NEAR(first_limit(path), 1.0, 5e-3);
    EXPECT_GT(path.back().load_factor, 1.5);  // through the snap, and stiff again
    EXPECT_TRUE(path.back().stable);
}

TEST(PathTracing, AgreesWithTheLoadPathWhereThatGoes) {
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

TEST(PathTracing, BadOptionsAreRefused) {
    const Assembly assembly = assemble(sample::star());
    EXPECT_THROW(trace_path(assembly, {.first_load_step = 0.0}), base::InputError);
    EXPECT_THROW(trace_path(assembly, {.steps = 0}), base::InputError);
}

}  // namespace
}  // namespace fretwork::mechanics
