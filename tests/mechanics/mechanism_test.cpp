// SPDX-License-Identifier: GPL-3.0-or-later
// Which supports leave a mechanism depends on places alone, whatever condenses the beams.
#include "sample.hpp"
#include "support.hpp"

#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/linear_element.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

namespace fretwork::mechanics {
namespace THIS_TEST {

using test::complaint_of;
using testing::HasSubstr;

/// A wheel of square bars whose tips 0 and 3 lie on the x axis, 1 and 2 above it, 4 and 5 below it. No
/// supports.
Frame wheel(double thickness) {
    Frame frame = sample::flat_wheel();
    frame.supports.clear();
    for (Beam& beam : frame.beams) beam.section = rectangle_section(thickness, thickness);
    return frame;
}

/// The wheel as one element between its tips.
Assembly condensed(const Frame& frame) {
    const std::vector<NodeIndex> tips = first_nodes(6);
    Assembly assembly;
    assembly.nodes.assign(frame.nodes.begin(), frame.nodes.begin() + 6);
    assembly.elements.push_back(linear_element(tips, {.stiffness = condense(assemble(frame), tips)}));
    assembly.supports = frame.supports;
    assembly.loads = NodeValues::Zero(6, kDofsPerNode);
    assembly.reported_nodes = 6;
    return assembly;
}

std::vector<Assembly> beams_and_condensed(double thickness, const std::vector<Support>& supports) {
    Frame frame = wheel(thickness);
    frame.supports = supports;
    return {assemble(frame), condensed(frame)};
}

constexpr DofSet kUx{{true, false, false, false, false, false}};
constexpr DofSet kUy{{false, true, false, false, false, false}};
constexpr DofSet kUz{{false, false, true, false, false, false}};

/// Supports that hold the wheel in its plane, and nothing more.
std::vector<Support> held_in_plane() {
    return {{NodeIndex(0), kUx}, {NodeIndex(0), kUy}, {NodeIndex(3), kUy}};
}

/// Supports that hold the wheel across its plane, and nothing more.
std::vector<Support> held_across() {
    return {{NodeIndex(0), kUz}, {NodeIndex(3), kUz}, {NodeIndex(1), kUz}};
}

std::vector<Support> joined(std::vector<Support> supports, const std::vector<Support>& more) {
    supports.insert(supports.end(), more.begin(), more.end());
    return supports;
}

// Rounding of thin bars resists rigid motions of condensed tiles far more than rounding of the factorization.
TEST(Mechanism, RigidMotionsAreToldForBeamsAndForCondensedTiles) {
    const std::vector<std::vector<Support>> cases = {
        held_across(),                                                        // moves in its plane
        held_in_plane(),                                                      // moves across it
        joined(held_in_plane(), {{NodeIndex(0), kUz}, {NodeIndex(3), kUz}}),  // turns about the x axis
        joined(held_across(), {{NodeIndex(0), kUx}, {NodeIndex(0), kUy}}),    // turns about node 0
        // Moves along y: two supports along one line hold the same motion.
        joined(held_across(), {{NodeIndex(0), kUx}, {NodeIndex(3), kUx}}),
        {{NodeIndex(0), kUz}, {NodeIndex(3), kUz}},
    };
    for (const double thickness : {2e-3, 2e-4, 2e-5}) {
        for (std::size_t i = 0; i < cases.size(); ++i) {
            for (const Assembly& assembly : beams_and_condensed(thickness, cases[i])) {
                const auto refusal = HasSubstr("the structure, as held, can move without strain at node ");
                EXPECT_THAT(complaint_of([&] { solve_linear(assembly); }), refusal) << thickness << " " << i;
                EXPECT_THAT(complaint_of([&] { follow_load_path(assembly, even_load_factors(1)); }), refusal)
                    << thickness << " " << i;
                EXPECT_THAT(complaint_of([&] { buckling_modes(assembly, 1); }), refusal)
                    << thickness << " " << i;
            }
        }
    }
}

// Six supports that hold every rigid motion once: statics gives their forces, whatever the stiffness. A force
// P across the plane at node 4 is as far below the x axis as node 1 above it, so node 1 takes P, and nodes 0
// and 3 take -P each. A force Q along y at the same node has the arm r/2 about the middle.
TEST(Mechanism, JustEnoughSupportsHaveTheReactionsOfStatics) {
    constexpr double kP = 0.3;
    constexpr double kQ = 0.2;
    for (const double thickness : {2e-3, 2e-4}) {
        for (Assembly& assembly : beams_and_condensed(thickness, joined(held_in_plane(), held_across()))) {
            assembly.loads(4, 1) = kQ;
            assembly.loads(4, 2) = kP;
            const NodeValues reactions = solve_linear(assembly).reactions;
            EXPECT_NEAR(reactions(1, 2), kP, 1e-6 * kP);
            EXPECT_NEAR(reactions(0, 2), -kP, 1e-6 * kP);
            EXPECT_NEAR(reactions(3, 2), -kP, 1e-6 * kP);
            EXPECT_NEAR(reactions(0, 1), -0.25 * kQ, 1e-6 * kQ);
            EXPECT_NEAR(reactions(3, 1), -0.75 * kQ, 1e-6 * kQ);
            EXPECT_NEAR(reactions(0, 0), 0.0, 1e-6 * kQ);
        }
    }
}

// A clamp holds rotations, too, in whatever unit lengths are given: u = F l^3 / 3EI.
TEST(Mechanism, AClampHoldsAStructureOfAnySize) {
    for (const double length : {1e-5, 1.0, 1e7}) {
        sample::CantileverShape shape;
        shape.length = length;
        shape.section = rectangle_section(length / 50.0, length / 50.0);
        Frame frame = sample::cantilever(shape);
        frame.loads.push_back({NodeIndex(1), {0.0, 0.0, 1.0}});
        const double bending_stiffness = shape.material.young_modulus * shape.section.I2;
        const double moved = length * length * length / (3.0 * bending_stiffness);
        // Shear adds (1 + nu) / 2 (h/l)^2 / kappa: less than a thousandth.
        EXPECT_NEAR(solve_linear(assemble(frame)).displacements(1, 2) / moved, 1.0, 1e-3) << length;
    }
}

// A beam on springs to the ground has no supports: u = F / k, and it turns by the moment over the springs'.
TEST(Mechanism, ElementThatIsHeldByItselfHoldsTheStructure) {
    Frame frame = sample::cantilever();
    frame.supports.clear();
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, 3.0}});
    Assembly assembly = assemble(frame);
    // Softer than the beam by far more than rounding: it counts all the same.
    for (const double stiffness : {2000.0, 2e-3}) {
        const Eigen::MatrixXd springs = stiffness * Eigen::MatrixXd::Identity(kDofsPerNode, kDofsPerNode);
        assembly.elements.resize(1);
        assembly.elements.push_back(linear_element({NodeIndex(0)}, {.stiffness = springs}));
        const NodeValues moved = solve_linear(assembly).displacements;
        EXPECT_NEAR(moved(0, 2), 3.0 / stiffness, 1e-6 * 3.0 / stiffness);
        EXPECT_NEAR(moved(0, 4), -3.0 / stiffness, 1e-6 * 3.0 / stiffness);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
