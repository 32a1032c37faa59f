// SPDX-License-Identifier: GPL-3.0-or-later
// Published benchmarks of buckling and of large rotations in space; equilibrium_test and path_tracing_test
// hold the others. Sources: experiments/verification/benchmark_frames.hpp.
#include "verification/benchmark_frames.hpp"

#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace THIS_TEST {

using Eigen::Vector3d;

/// Both ways to a critical load: linearized, and by following the path to beyond it.
struct CriticalFactors {
    double linearized, followed;
};

CriticalFactors critical_factors(const Frame& frame) {
    const Assembly assembly = assemble(frame);
    const double factors[] = {0.5, 0.9, 1.2};
    const auto path = follow_load_path(assembly, factors, {.locate_critical_loads = true});
    EXPECT_TRUE(path[2].converged());
    EXPECT_EQ(path[2].stability_losses.size(), 1u);
    if (path[2].stability_losses.empty()) return {0.0, 0.0};
    return {buckling_modes(assembly, 1)[0].value, path[2].stability_losses[0].load_factor};
}

// The value is of the geometrically exact rod (experiments/verification/shooting.py). The frame bends a
// little in its plane before it buckles, which linearized buckling leaves out.
TEST(Benchmark, RightAngleFrameBucklesLaterallyUnderTipForce) {
    const auto found = critical_factors(verification::right_angle_frame());
    EXPECT_NEAR(found.followed, 1.0, 5e-5);
    EXPECT_NEAR(found.linearized, 1.0, 1e-3);
}

// The value is of the geometrically exact rod. In space the error of flat sections falls with the square of
// the number of divisions: 64 leave 1e-4.
TEST(Benchmark, HingedRightAngleFrameBucklesUnderEndMoments) {
    for (const double sign : {1.0, -1.0}) {
        const auto found = critical_factors(verification::hinged_right_angle_frame(sign));
        EXPECT_NEAR(found.followed, 1.0, 2e-4) << sign;
        EXPECT_NEAR(found.linearized, 1.0, 2e-4) << sign;
    }
}

// The exact value.
TEST(Benchmark, ShaftHasItsCriticalTorque) {
    const auto found = critical_factors(verification::hockling_shaft());
    EXPECT_NEAR(found.followed, 1.0, 2e-4);
    EXPECT_NEAR(found.linearized, 1.0, 2e-4);
}

// The values are of the geometrically exact rod with shear by shooting.
TEST(Benchmark, MomentAndForceWindCantileverIntoHelix) {
    std::vector<double> factors;
    for (int k = 1; k <= 200; ++k) factors.push_back(k / 200.0);
    const auto path = follow_load_path(assemble(verification::helix_cantilever(160)), factors);
    const Vector3d tenth = path[19].displacements.row(1).head<3>();
    EXPECT_LT((tenth - Vector3d(-9.58980, 0.05377, -1.09173)).norm(), 1e-5) << tenth.transpose();
    // At full load each element turns by 22 degrees, and with shear the order is two: four times as much is
    // off with 80 elements, a fourth with 320. Shear angles are far from small here, as nowhere else.
    const Vector3d full = path[199].displacements.row(1).head<3>();
    ASSERT_TRUE(path[199].converged());
    EXPECT_LT((full - Vector3d(-9.99520, 0.00007, -0.07644)).norm(), 6e-4) << full.transpose();
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
