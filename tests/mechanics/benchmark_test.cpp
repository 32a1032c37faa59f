// SPDX-License-Identifier: GPL-3.0-or-later
// Published benchmarks of buckling and of large rotations in space.
#include "sample.hpp"

#include <fretwork/mechanics/equilibrium.hpp>
#include <fretwork/mechanics/modes.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kLeg = 240.0;

/// Argyris' strip, 30 deep in the plane of the frame and 0.6 thick; axis 3 is out of the plane.
Beam strip(int from, int to) {
    return {.nodes = {NodeIndex(from), NodeIndex(to)},
            .section = {.area = 18.0, .I2 = 30.0 * 0.216 / 12.0, .I3 = 0.6 * 27000.0 / 12.0, .J = 2.16},
            .material = {.young_modulus = 71240.0, .poisson_ratio = 0.31},
            .divisions = 16};
}

// Argyris et al., Comp. Meth. Appl. Mech. Eng. 20 (1979): a right angle of two legs, clamped at one end,
// pulled at the other along the clamped leg. Lateral buckling at 1.088 there, 1.089 by an independent
// corotational program; the frame hardly bends in its plane before, so linearized buckling is close.
TEST(Benchmark, RightAngleFrameBucklesSidewaysUnderATipForce) {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {kLeg, 0, 0}, {kLeg, -kLeg, 0}};
    frame.beams = {strip(0, 1), strip(1, 2)};
    sample::clamp(frame, 0);
    frame.loads.push_back({NodeIndex(2), {1.0, 0.0, 0.0}});
    const Assembly assembly = assemble(frame);
    const double factors[] = {0.5, 1.0, 1.5};
    const auto path = follow_load_path(assembly, factors, {.locate_critical_loads = true});
    ASSERT_EQ(path[2].stability_losses.size(), 1u);
    EXPECT_NEAR(path[2].stability_losses[0].load_factor, 1.089, 2e-3);
    EXPECT_NEAR(buckling_modes(assembly, 1)[0].value, 1.089, 3e-3);
}

// The same with hinged ends that may turn in the plane and slide along their line, under opposite end
// moments: 624.77 in Argyris et al., 626 in Simo and Vu-Quoc (1986), 624.6 by an independent corotational
// program.
TEST(Benchmark, HingedRightAngleFrameBucklesUnderEndMoments) {
    Frame frame;
    const double half = kLeg / std::sqrt(2.0);
    frame.nodes = {{-half, 0, 0}, {0, half, 0}, {half, 0, 0}};
    frame.beams = {strip(0, 1), strip(1, 2)};
    for (const int end : {0, 2})
        frame.supports.push_back({NodeIndex(end), {{false, true, true, true, true, false}}});
    frame.supports.push_back({NodeIndex(1), {{true, false, false, false, false, false}}});
    frame.loads.push_back({NodeIndex(0), Vector3d::Zero(), {0.0, 0.0, 1.0}});
    frame.loads.push_back({NodeIndex(2), Vector3d::Zero(), {0.0, 0.0, -1.0}});
    for (const double sign : {1.0, -1.0}) {
        for (NodalLoad& load : frame.loads) load.moment *= sign;
        const Assembly assembly = assemble(frame);
        const double factors[] = {400.0, 800.0};
        const auto path = follow_load_path(assembly, factors, {.locate_critical_loads = true});
        ASSERT_EQ(path[1].stability_losses.size(), 1u) << sign;
        EXPECT_NEAR(path[1].stability_losses[0].load_factor, 624.6, 2.0) << sign;
        EXPECT_NEAR(buckling_modes(assembly, 1)[0].value, 624.6, 2.0) << sign;
    }
}

// Ibrahimbegovic, Comp. Meth. Appl. Mech. Eng. 122 (1995): ten turns under a moment, pulled into a helix. The
// values are of the geometrically exact rod with shear by shooting.
TEST(Benchmark, AMomentWindsACantileverIntoAHelix) {
    Frame frame = sample::cantilever({.length = 10.0,
                                      .divisions = 160,
                                      .section = {.area = 1.0, .I2 = 0.01, .I3 = 0.01, .J = 0.01},
                                      .material = {.young_modulus = 1e4}});
    frame.beams[0].material.given_shear_modulus = 1e4;
    frame.beams[0].section.shear_area2 = frame.beams[0].section.shear_area3 = 1.0;
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, 50.0}, {0.0, 0.0, 200.0 * kPi}});
    std::vector<double> factors;
    for (int k = 1; k <= 200; ++k) factors.push_back(k / 200.0);
    const auto path = follow_load_path(assemble(frame), factors);
    const Vector3d tenth = path[19].displacements.row(1).head<3>();
    EXPECT_LT((tenth - Vector3d(-9.58980, 0.05377, -1.09173)).norm(), 3e-5) << tenth.transpose();
    // At full load each element turns by 22 degrees, and with shear the order is two.
    const Vector3d full = path[199].displacements.row(1).head<3>();
    ASSERT_TRUE(path[199].converged());
    EXPECT_LT((full - Vector3d(-9.99520, 0.00007, -0.07644)).norm(), 0.02) << full.transpose();
}

// Hockling (Simo and Vu-Quoc 1986): a shaft whose ends cannot bend, under a torque at the end that slides and
// turns: 2 * 4.493409 E I / L, where 4.493409 is the first root of tan x = x.
TEST(Benchmark, AShaftHocklesUnderItsTorque) {
    Frame frame = sample::cantilever({.length = kLeg,
                                      .divisions = 16,
                                      .section = {.area = 1.0, .I2 = 0.0833, .I3 = 0.0833, .J = 2.16},
                                      .material = {.young_modulus = 71240.0}});
    frame.beams[0].material.given_shear_modulus = 27190.0;
    frame.supports.push_back({NodeIndex(1), {{false, true, true, false, true, true}}});
    const double expected = 2.0 * 4.493409 * 71240.0 * 0.0833 / kLeg;
    frame.loads.push_back({NodeIndex(1), Vector3d::Zero(), {expected, 0.0, 0.0}});
    const Assembly assembly = assemble(frame);
    const double factors[] = {0.5, 0.9, 1.1};
    const auto path = follow_load_path(assembly, factors, {.locate_critical_loads = true});
    ASSERT_EQ(path[2].stability_losses.size(), 1u);
    EXPECT_NEAR(path[2].stability_losses[0].load_factor, 1.0, 2e-4);
    EXPECT_NEAR(buckling_modes(assembly, 1)[0].value, 1.0, 2e-4);
}

}  // namespace
}  // namespace fretwork::mechanics
