// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/linear_element.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace THIS_TEST {

constexpr double kPi = std::numbers::pi;

// Blevins, Formulas for Natural Frequency and Mode Shape: (b L)^2 / 2 pi sqrt(E I / m L^4), b L
// = 1.87510407, 4.69409113.
TEST(Modes, FrequenciesOfCantileverMatchClosedForms) {
    const auto modes = vibration_modes(assemble(sample::cantilever({.divisions = 10})), 4);
    ASSERT_EQ(modes.size(), 4u);
    const double mass = 1000.0 * 0.01;
    const double first = 1.87510407 * 1.87510407 / (2.0 * kPi);
    const double second = 4.69409113 * 4.69409113 / (2.0 * kPi);
    EXPECT_NEAR(modes[0].value, first * std::sqrt(1e3 / mass), 1e-5 * modes[0].value);
    EXPECT_NEAR(modes[1].value, first * std::sqrt(2e3 / mass), 1e-5 * modes[1].value);
    EXPECT_NEAR(modes[2].value, second * std::sqrt(1e3 / mass), 1e-4 * modes[2].value);
    EXPECT_NEAR(modes[3].value, second * std::sqrt(2e3 / mass), 1e-4 * modes[3].value);
    EXPECT_NEAR(std::abs(modes[0].shape(1, 2)), 1.0, 1e-12);
    EXPECT_NEAR(modes[0].shape(1, 1), 0.0, 1e-9);
}

// Euler: clamped and free, pi^2 E I / (4 L^2), for bending about each axis.
TEST(Modes, BucklingLoadsOfColumnAreEulers) {
    // So stiff along its axis that it does not shorten before it buckles.
    const Section section{.area = 10.0, .I2 = 1e-6, .I3 = 2e-6, .J = 2.5e-6};
    Frame frame = sample::cantilever({.divisions = 8, .section = section});
    frame.loads.push_back({NodeIndex(1), {-1.0, 0.0, 0.0}});
    const auto modes = buckling_modes(assemble(frame), 3);
    ASSERT_EQ(modes.size(), 3u);
    EXPECT_NEAR(modes[0].value, kPi * kPi / 4.0 * 1e3, 1e-4 * modes[0].value);
    EXPECT_NEAR(modes[1].value, kPi * kPi / 4.0 * 2e3, 1e-4 * modes[1].value);
    EXPECT_NEAR(modes[2].value, 9.0 * kPi * kPi / 4.0 * 1e3, 1e-3 * modes[2].value);
}

// Rounding of a stiffness of so many divisions moves the factors by more than the tolerance of the iteration.
TEST(Modes, BucklingLoadHoldsForFineDivisions) {
    Frame frame = sample::cantilever(
        {.divisions = 500, .section = {.area = 10.0, .I2 = 1e-6, .I3 = 2e-6, .J = 2.5e-6}});
    frame.loads.push_back({NodeIndex(1), {-1.0, 0.0, 0.0}});
    const auto modes = buckling_modes(assemble(frame), 2);
    ASSERT_EQ(modes.size(), 2u);
    EXPECT_NEAR(modes[0].value, kPi * kPi / 4.0 * 1e3, 1e-4 * modes[0].value);
    EXPECT_NEAR(modes[1].value, kPi * kPi / 4.0 * 2e3, 1e-4 * modes[1].value);
}

// The frame's nodes do not move, but the inside of the beam does, and nodes turn with it: pi times the
// amplitude in a length.
TEST(Modes, AreScaledByLargestDisplacementInsideBeamsToo) {
    Frame frame = sample::cantilever({.divisions = 16});
    frame.supports = {{NodeIndex(0), {{true, true, true, true, false, false}}},
                      {NodeIndex(1), {{true, true, true, false, false, false}}}};
    frame.loads.push_back({NodeIndex(1), {-1.0, 0.0, 0.0}});
    frame.supports[1].fixed.contains[0] = false;
    for (const auto& modes : {vibration_modes(assemble(frame), 1), buckling_modes(assemble(frame), 1)}) {
        ASSERT_EQ(modes.size(), 1u);
        EXPECT_NEAR(modes[0].inner_shape.cwiseAbs().col(2).maxCoeff(), 1.0, 1e-12);
        EXPECT_NEAR(std::abs(modes[0].shape(0, 4)), kPi, 1e-3);
    }
}

// In linearized buckling nothing depends on how far the structure bends before.
TEST(Modes, TransverseForceDoesNotChangeBucklingLoads) {
    // Every node is held in the plane of the bending: else it would buckle sideways.
    Frame frame;
    const Beam bar = sample::cantilever().beams.front();
    for (int i = 0; i <= 8; ++i) {
        frame.nodes.emplace_back(i / 8.0, 0.0, 0.0);
        frame.supports.push_back({NodeIndex(i), {{false, true, false, true, false, true}}});
        if (i == 0) continue;
        frame.beams.push_back(bar);
        frame.beams.back().nodes = {NodeIndex(i - 1), NodeIndex(i)};
    }
    sample::clamp(frame, 0);
    // A shear force turns with its beam, and so meets the axial stiffness: an effect of the axial strain's
    // size.
    for (const double across : {0.0, 0.01, 1.0}) {
        frame.loads = {{NodeIndex(8), {-1.0, 0.0, across}}};
        const auto modes = buckling_modes(assemble(frame), 1);
        ASSERT_EQ(modes.size(), 1u);
        EXPECT_NEAR(modes[0].value, kPi * kPi / 4.0 * 1e3, 5e-4 * modes[0].value) << across;
    }
    const Eigen::Vector3d across(0.0, 0.0, 1.0);
    frame.loads = {{NodeIndex(8), across}};
    for (const Mode& mode : buckling_modes(assemble(frame), 1)) EXPECT_GT(mode.value, 100.0 * 1e3);
}

// Euler: pinned at both ends, by a hinge of the beam at one and of the support at the other.
TEST(Modes, HingedColumnHasBucklingLoadOfPinnedColumn) {
    Frame frame = sample::cantilever({.divisions = 8});
    frame.beams[0].releases = {{0, {{false, false, false, false, true, true}}}};
    frame.supports.push_back({NodeIndex(1), {{false, true, true, true, false, false}}});
    frame.loads = {{NodeIndex(1), {-1.0, 0.0, 0.0}}};
    const auto modes = buckling_modes(assemble(frame), 2);
    ASSERT_EQ(modes.size(), 2u);
    EXPECT_NEAR(modes[0].value, kPi * kPi * 1e3, 1e-3 * modes[0].value);
    EXPECT_NEAR(modes[1].value, kPi * kPi * 2e3, 1e-3 * modes[1].value);
}

// Nothing loads it: no loads, a load on a node that is held, a displacement of zero.
TEST(Modes, StructureAtRestHasNoBucklingLoad) {
    Frame frame = sample::cantilever({.divisions = 4});
    EXPECT_TRUE(buckling_modes(assemble(frame), 1).empty());
    frame.loads.push_back({NodeIndex(0), {-1.0, 2.0, 3.0}});
    EXPECT_TRUE(buckling_modes(assemble(frame), 8).empty());
    frame.prescribed.push_back({NodeIndex(1), Dof::ux, 0.0});
    EXPECT_TRUE(buckling_modes(assemble(frame), 1000).empty());
}

// Supports that move a structure as a rigid body load it with nothing; forces of rounding have buckling
// loads.
TEST(Modes, StructureThatSupportsMoveAsARigidBodyHasNoBucklingLoad) {
    Frame frame = sample::cantilever({.divisions = 8});
    frame.nodes[1] = {0.4, 0.3, -0.8};
    frame.supports = {{NodeIndex(0), {{false, true, true, true, true, true}}}};
    frame.prescribed.push_back({NodeIndex(0), Dof::ux, 0.02});
    EXPECT_TRUE(buckling_modes(assemble(frame), 2).empty());
    // Held at its other end, the beam is compressed and bent.
    sample::clamp(frame, 1);
    EXPECT_FALSE(buckling_modes(assemble(frame), 2).empty());
}

// Both ends of a beam in one piece.
TEST(Modes, StructureWithAllNodesHeldHasNoModes) {
    Frame frame = sample::cantilever({.divisions = 1});
    sample::clamp(frame, 1);
    EXPECT_TRUE(vibration_modes(assemble(frame), 3).empty());
    EXPECT_TRUE(buckling_modes(assemble(frame), 3).empty());
    frame.beams[0].material.density = 0.0;
    EXPECT_THROW(vibration_modes(assemble(frame), 3), base::InputError);
}

TEST(Modes, AreNoMoreThanFreeComponents) {
    EXPECT_EQ(vibration_modes(assemble(sample::cantilever({.divisions = 1})), 50).size(), 6u);
}

TEST(Modes, ColumnInTensionHasNoBucklingLoad) {
    Frame frame = sample::cantilever({.divisions = 4});
    frame.loads.push_back({NodeIndex(1), {1.0, 0.0, 0.0}});
    EXPECT_TRUE(buckling_modes(assemble(frame), 3).empty());
}

// Argyris et al. (1979), right-angle frame, and Timoshenko's strip: lateral buckling of a cantilever strip
// under a tip force, P = 4.0126 sqrt(E I G J) / L^2.
TEST(Modes, StripBucklesLaterally) {
    const Section strip{.area = 1e-4, .I2 = 1e-5, .I3 = 1e-9, .J = 4e-9};
    Frame frame = sample::cantilever({.divisions = 16, .section = strip});
    frame.loads.push_back({NodeIndex(1), {0.0, 0.0, -1.0}});
    const auto modes = buckling_modes(assemble(frame), 1);
    ASSERT_EQ(modes.size(), 1u);
    EXPECT_NEAR(modes[0].value, 4.0126 * std::sqrt(1.0 * 2.0), 3e-3 * modes[0].value);
}

TEST(Modes, BadRequestsAreRefused) {
    for (const int count : {0, kMostModes + 1, 1'000'000'000}) {
        EXPECT_THROW(vibration_modes(assemble(sample::star()), count), base::InputError) << count;
        EXPECT_THROW(buckling_modes(assemble(sample::star()), count), base::InputError) << count;
    }
    Frame weightless = sample::cantilever();
    weightless.beams[0].material.density = 0.0;
    EXPECT_THROW(vibration_modes(assemble(weightless), 1), base::InputError);
}

/// A planar grid of 4 x 3 squares, held at two corners, pushed and pulled in its plane: about as many of its
/// buckling loads are of the reversed load as of this one.
Frame pushed_grid() {
    Frame frame;
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 5; ++i) frame.nodes.emplace_back(0.1 * i, 0.1 * j, 0.0);
    }
    for (int n = 0; n < 20; ++n) {
        if (n % 5 < 4) frame.beams.push_back(sample::beam_between(n, n + 1));
        if (n < 15) frame.beams.push_back(sample::beam_between(n, n + 5));
    }
    sample::clamp(frame, 0);
    sample::clamp(frame, 4);
    frame.loads.push_back({NodeIndex(17), {40.0, -25.0, 0.0}});
    return frame;
}

/// The positive buckling loads by dense matrices.
std::vector<double> dense_buckling_loads(const Frame& frame) {
    const Assembly assembly = assemble(frame);
    const NodeValues rate = solve_linear(assembly).displacements;
    const auto size = static_cast<Eigen::Index>(assembly.nodes.size()) * kDofsPerNode;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
    Eigen::MatrixXd S = K;
    for (const auto& element : assembly.elements) {
        std::vector<Eigen::Index> dofs;
        for (const NodeIndex node : element->nodes())
            for (int d = 0; d < kDofsPerNode; ++d) dofs.push_back(node.value * kDofsPerNode + d);
        Eigen::VectorXd moved(static_cast<Eigen::Index>(dofs.size()));
        for (std::size_t i = 0; i < dofs.size(); ++i)
            moved[static_cast<Eigen::Index>(i)] = rate(dofs[i] / kDofsPerNode, dofs[i] % kDofsPerNode);
        Eigen::MatrixXd stiffness;
        element->rest_stiffness(stiffness);
        K(dofs, dofs) += stiffness;
        element->geometric_stiffness(moved, stiffness);
        S(dofs, dofs) -= stiffness;
    }
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < size; ++i)
        if (i / kDofsPerNode != 0 && i / kDofsPerNode != 4) free.push_back(i);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(S(free, free)),
                                                                           Eigen::MatrixXd(K(free, free)));
    std::vector<double> loads;
    for (Eigen::Index i = solver.eigenvalues().size(); i-- > 0;)
        if (solver.eigenvalues()[i] > 0.0) loads.push_back(1.0 / solver.eigenvalues()[i]);
    return loads;
}

TEST(Modes, BucklingLoadsOfReversedLoadHideNone) {
    const std::vector<double> expected = dense_buckling_loads(pushed_grid());
    ASSERT_GT(expected.size(), 30U);
    for (const int count : {1, 2, 5, 30}) {
        const auto found = buckling_modes(assemble(pushed_grid()), count);
        ASSERT_EQ(std::ssize(found), count);
        for (int i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            EXPECT_NEAR(found[at].value, expected[at], 1e-7 * expected[at]) << i << " of " << count;
        }
    }
}

/// The only element of a frame as a linear element of the same matrices.
enum class Mass { Given, Unknown };
Assembly as_linear_element(Assembly assembly, Mass mass) {
    const Element& beam = *assembly.elements.front();
    LinearMatrices matrices;
    beam.rest_stiffness(matrices.stiffness);
    if (mass == Mass::Given) beam.mass(matrices.mass);
    const auto nodes = beam.nodes();
    assembly.elements.front() = linear_element({nodes.begin(), nodes.end()}, matrices);
    return assembly;
}

TEST(Modes, LinearElementVibratesWithTheMassThatItWasGiven) {
    const Assembly beam = assemble(sample::cantilever());
    const auto expected = vibration_modes(beam, 2);
    const auto found = vibration_modes(as_linear_element(assemble(sample::cantilever()), Mass::Given), 2);
    ASSERT_EQ(found.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(found[i].value, expected[i].value, 1e-9 * expected[i].value);
}

TEST(Modes, LinearElementWithoutAMassIsRefused) {
    EXPECT_THROW(vibration_modes(as_linear_element(assemble(sample::cantilever()), Mass::Unknown), 1),
                 base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
