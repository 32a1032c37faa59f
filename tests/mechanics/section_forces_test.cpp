// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/node_states.hpp>
#include <fretwork/mechanics/results/section_forces.hpp>
#include <fretwork/mechanics/results/section_stress.hpp>
#include <fretwork/mechanics/solve.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace fretwork::mechanics {
namespace THIS_TEST {

constexpr double kLength = 0.3;

/// A cantilever along x, whose axes 1 2 3 are x y z, with a force and a moment at its tip.
Frame cantilever(const Eigen::Vector3d& force, const Eigen::Vector3d& moment) {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {kLength, 0, 0}};
    frame.beams.push_back({.nodes = {NodeIndex(0), NodeIndex(1)},
                           .section = rectangle_section(0.004, 0.002),
                           .material = {.young_modulus = 1e9, .poisson_ratio = 0.3}});
    frame.supports.push_back({NodeIndex(0), DofSet::all()});
    frame.loads.push_back({NodeIndex(1), force, moment});
    return frame;
}

BeamSection section_of(const Frame& frame) {
    return {frame.beams.front(), {frame.nodes[0], frame.nodes[1]}};
}

BeamSection::Ends linear_forces(const Frame& frame) {
    const NodeValues moved = solve({frame, {}}, {.solver = Solver::Linear}).solution.displacements;
    return section_of(frame).linear(moved.row(0).transpose(), moved.row(1).transpose());
}

// Statics of a cantilever: the cut at s carries the tip's force, and its moment plus (L - s) e1 x force.
// Rounding: the deflection is 1e3 times that of the membrane, and squared in the condition.
constexpr double kRounding = 1e-9;

TEST(SectionForces, OfACantileverAreThoseOfStatics) {
    const Eigen::Vector3d force(3.0, 0.02, -0.05);
    const Eigen::Vector3d moment(0.001, 0.002, -0.003);
    const auto [start, end] = linear_forces(cantilever(force, moment));
    for (const SectionForces& cut : {start, end}) {
        EXPECT_NEAR(cut.N, force.x(), kRounding);
        EXPECT_NEAR(cut.V2, force.y(), kRounding);
        EXPECT_NEAR(cut.V3, force.z(), kRounding);
        EXPECT_NEAR(cut.T, moment.x(), kRounding);
    }
    EXPECT_NEAR(end.M2, moment.y(), kRounding);
    EXPECT_NEAR(end.M3, moment.z(), kRounding);
    EXPECT_NEAR(start.M2, moment.y() - kLength * force.z(), kRounding);
    EXPECT_NEAR(start.M3, moment.z() + kLength * force.y(), kRounding);
}

TEST(SectionForces, TurnWithTheBeam) {
    const Frame frame = cantilever({3.0, 0.02, -0.05}, {0.001, 0.002, -0.003});
    const NodeValues moved = solve({frame, {}}, {.solver = Solver::Linear}).solution.displacements;
    const BeamSection section = section_of(frame);
    const auto at_rest = section.large(
        {}, {moved.row(1).head<3>().transpose(), geometry::exponential(moved.row(1).tail<3>().transpose())});
    const Eigen::Quaterniond turn = geometry::exponential({0.4, 2.0, -1.1});
    const auto turned = [&](const Eigen::Vector3d& place, const Eigen::Vector<double, 6>& row) {
        const Eigen::Vector3d now = turn * (place + row.head<3>());
        return NodeState{now - place, turn * geometry::exponential(row.tail<3>())};
    };
    const auto after = section.large(turned(frame.nodes[0], moved.row(0).transpose()),
                                     turned(frame.nodes[1], moved.row(1).transpose()));
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(after[i].N, at_rest[i].N, kRounding * 1e3);
        EXPECT_NEAR(after[i].M2, at_rest[i].M2, kRounding);
        EXPECT_NEAR(after[i].M3, at_rest[i].M3, kRounding);
        EXPECT_NEAR(after[i].T, at_rest[i].T, kRounding);
    }
}

TEST(SectionForces, OfSmallDisplacementsAreTheSameEitherWay) {
    const Frame frame = cantilever({1e-6, 2e-6, -5e-6}, {1e-7, 2e-7, -3e-7});
    const NodeValues moved = solve({frame, {}}, {.solver = Solver::Linear}).solution.displacements;
    const auto linear = linear_forces(frame);
    const auto large = section_of(frame).large(
        {}, {moved.row(1).head<3>().transpose(), geometry::exponential(moved.row(1).tail<3>().transpose())});
    // Displacements are 1e-4 of the length: what is of their second order is left out.
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(large[i].M2, linear[i].M2, 1e-3 * std::abs(linear[i].M2) + 1e-12);
        EXPECT_NEAR(large[i].M3, linear[i].M3, 1e-3 * std::abs(linear[i].M3) + 1e-12);
        EXPECT_NEAR(large[i].V2, linear[i].V2, 1e-3 * std::abs(linear[i].V2) + 1e-12);
        EXPECT_NEAR(large[i].V3, linear[i].V3, 1e-3 * std::abs(linear[i].V3) + 1e-12);
        EXPECT_NEAR(large[i].T, linear[i].T, 1e-3 * std::abs(linear[i].T));
    }
}

TEST(SectionForces, StressOfARectangleIsThatOfItsWorstCorner) {
    const double width = 0.004;
    const double height = 0.002;
    const SectionForces forces{.N = -3.0, .M2 = 0.01, .M3 = -0.02};
    const double expected = 3.0 / (width * height) + 0.01 * 6.0 / (width * height * height) +
                            0.02 * 6.0 / (height * width * width);
    EXPECT_NEAR(SectionPoints(rectangle_section(width, height)).largest(forces).normal, expected,
                1e-9 * expected);
}

TEST(SectionForces, ABeamOfNoLengthIsRefused) {
    Frame frame = cantilever({0, 0, 0}, {0, 0, 0});
    frame.nodes[1] = frame.nodes[0];
    EXPECT_THROW((void)section_of(frame), base::GeometryError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
