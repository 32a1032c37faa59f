// SPDX-License-Identifier: GPL-3.0-or-later
#include "element_kinds.hpp"

#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/elements/beam_element.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics {
namespace THIS_TEST {

using Eigen::MatrixXd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;
using sample::every_kind;
using sample::kLength;
using sample::move;
using sample::one_beam;
using sample::only_element;
using sample::Random;
using sample::random_states;
using sample::scaled;

/// Central differences of energy and force along displacements and spins. Displacements are of the size of
/// the beam, rotations of one: so are the steps.
struct Differences {
    VectorXd force;
    MatrixXd tangent;
};

Differences differentiate(const Element& element, const std::vector<NodeState>& states) {
    const auto size = static_cast<Eigen::Index>(states.size()) * kDofsPerNode;
    Differences result{VectorXd(size), MatrixXd(size, size)};
    ElementResponse plus, minus;
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto node = static_cast<std::size_t>(i / kDofsPerNode);
        const int dof = static_cast<int>(i % kDofsPerNode);
        const double step = 1e-5 * (dof < 3 ? kLength : 1.0);
        auto moved = states;
        move(moved[node], dof, step);
        element.evaluate(moved, Demand::Force, plus);
        moved = states;
        move(moved[node], dof, -step);
        element.evaluate(moved, Demand::Force, minus);
        result.force[i] = (plus.energy - minus.energy) / (2.0 * step);
        result.tangent.col(i) = (plus.force - minus.force) / (2.0 * step);
    }
    return result;
}

TEST(Element, ForceIsTheGradientOfTheEnergyAtLargeRotations) {
    for (const auto& [name, element] : every_kind()) {
        Random random(1);
        for (int trial = 0; trial < 20; ++trial) {
            const auto states = random_states(element->nodes().size(), 0.5, random);
            ElementResponse response;
            element->evaluate(states, Demand::Force, response);
            const MatrixXd difference = scaled(differentiate(*element, states).force);
            EXPECT_LT((scaled(response.force) - difference).norm(), 1e-8 * difference.norm()) << name;
        }
    }
}

TEST(Element, TangentIsTheDerivativeOfTheForceAtLargeRotations) {
    for (const auto& [name, element] : every_kind()) {
        Random random(2);
        for (int trial = 0; trial < 20; ++trial) {
            const auto states = random_states(element->nodes().size(), 0.5, random);
            ElementResponse response;
            element->evaluate(states, Demand::Tangent, response);
            EXPECT_LT((response.tangent - response.tangent.transpose()).norm(),
                      1e-12 * response.tangent.norm());
            MatrixXd derivative = response.tangent;
            for (Eigen::Index at = 3; at < derivative.rows(); at += kDofsPerNode) {
                const Vector3d moment = response.force.segment<3>(at);
                derivative.block<3, 3>(at, at) -= 0.5 * geometry::cross_matrix(moment);
            }
            const MatrixXd difference = scaled(differentiate(*element, states).tangent);
            EXPECT_LT((scaled(derivative) - difference).norm(), 1e-8 * difference.norm()) << name;
        }
    }
}

TEST(Element, RestStiffnessIsTheTangentAtRest) {
    for (const auto& [name, element] : every_kind()) {
        ElementResponse response;
        element->evaluate(std::vector<NodeState>(element->nodes().size()), Demand::Tangent, response);
        MatrixXd stiffness;
        element->rest_stiffness(stiffness);
        EXPECT_LT((stiffness - response.tangent).norm(), 1e-14 * stiffness.norm()) << name;
        EXPECT_LT(response.force.norm(), 1e-14 * stiffness.norm()) << name;
    }
}

// Przemieniecki, Theory of Matrix Structural Analysis, eq. (5.116): the textbook element, with shear.
TEST(BeamElement, RestStiffnessMatchesTheTextbook) {
    const Section section{
        .area = 2e-6, .I2 = 3e-13, .I3 = 5e-13, .J = 4e-13, .shear_area2 = 1e-6, .shear_area3 = 2e-6};
    const Material material{.young_modulus = 1e9, .poisson_ratio = 0.25};
    const double l = 0.02;
    const double shear = material.shear_modulus();
    const elements::BeamElement element({{NodeIndex(0), NodeIndex(1)}, l, Eigen::Matrix3d::Identity()},
                                        section, material);
    MatrixXd k;
    element.rest_stiffness(k);
    const double phi_y = 12.0 * 1e9 * section.I3 / (shear * *section.shear_area2 * l * l);
    const double phi_z = 12.0 * 1e9 * section.I2 / (shear * *section.shear_area3 * l * l);
    EXPECT_NEAR(k(0, 0), 1e9 * section.area / l, 1e-6);
    EXPECT_NEAR(k(1, 1), 12.0 * 1e9 * section.I3 / (l * l * l * (1.0 + phi_y)), 1e-8);
    EXPECT_NEAR(k(2, 2), 12.0 * 1e9 * section.I2 / (l * l * l * (1.0 + phi_z)), 1e-8);
    EXPECT_NEAR(k(3, 3), shear * section.J / l, 1e-12);
    EXPECT_NEAR(k(4, 4), (4.0 + phi_z) * 1e9 * section.I2 / (l * (1.0 + phi_z)), 1e-12);
    EXPECT_NEAR(k(5, 5), (4.0 + phi_y) * 1e9 * section.I3 / (l * (1.0 + phi_y)), 1e-12);
    EXPECT_NEAR(k(4, 10), (2.0 - phi_z) * 1e9 * section.I2 / (l * (1.0 + phi_z)), 1e-12);
    EXPECT_NEAR(k(5, 11), (2.0 - phi_y) * 1e9 * section.I3 / (l * (1.0 + phi_y)), 1e-12);
    EXPECT_NEAR(k(1, 5), 6.0 * 1e9 * section.I3 / (l * l * (1.0 + phi_y)), 1e-10);
    EXPECT_NEAR(k(2, 4), -6.0 * 1e9 * section.I2 / (l * l * (1.0 + phi_z)), 1e-10);
}

TEST(BeamElement, RigidMotionProducesNoForce) {
    const auto element = only_element(one_beam());
    Random random(3);
    for (int trial = 0; trial < 20; ++trial) {
        auto states = random_states(2, 0.0, random);
        const Vector3d shift = random.vector(1.0);
        for (NodeState& state : states) state.displacement += shift;
        ElementResponse response;
        element->evaluate(states, Demand::Force, response);
        // The stiffness times the rounding of positions a hundred times as far as the beam is long.
        EXPECT_LT(response.force.norm(), 1e-8);
        EXPECT_LT(response.energy, 1e-18);
    }
}

TEST(BeamElement, ForceAndTangentRotateWithTheBeam) {
    const auto element = only_element(one_beam());
    Random random(4);
    for (int trial = 0; trial < 20; ++trial) {
        const auto states = random_states(2, 0.5, random);
        const Quaterniond turn = random.rotation();
        auto turned = states;
        for (std::size_t i = 0; i < 2; ++i) {
            const Vector3d rest = static_cast<double>(i) * kLength * Vector3d(0.6, -0.48, 0.64);
            turned[i].displacement = turn * (rest + states[i].displacement) - rest;
            turned[i].rotation = turn * states[i].rotation;
        }
        ElementResponse before, after;
        element->evaluate(states, Demand::Force, before);
        element->evaluate(turned, Demand::Force, after);
        EXPECT_NEAR(after.energy, before.energy, 1e-12 * before.energy);
        for (Eigen::Index at = 0; at < 12; at += 3) {
            const Vector3d expected = turn * Vector3d(before.force.segment<3>(at));
            EXPECT_LT((after.force.segment<3>(at) - expected).norm(), 1e-11 * before.force.norm());
        }
    }
}

TEST(BeamElement, EndForcesAreInEquilibrium) {
    const auto element = only_element(one_beam());
    Random random(5);
    const auto states = random_states(2, 0.5, random);
    ElementResponse response;
    element->evaluate(states, Demand::Force, response);
    const Vector3d arm =
        kLength * Vector3d(0.6, -0.48, 0.64) + states[1].displacement - states[0].displacement;
    const Vector3d force = response.force.segment<3>(6);
    EXPECT_LT((response.force.segment<3>(0) + force).norm(), 1e-12 * force.norm());
    const Vector3d moment = response.force.segment<3>(3) + response.force.segment<3>(9) + arm.cross(force);
    EXPECT_LT(moment.norm(), 1e-12 * (force.norm() * kLength));
}

TEST(BeamElement, RoundSectionIsIndependentOfItsAxes) {
    Frame frame = one_beam();
    frame.beams[0].section = circle_section(0.002);
    const auto one = only_element(frame);
    frame.beams[0].normal = Vector3d(-1.0, 0.2, 0.7);
    const auto other = only_element(frame);
    Random random(6);
    for (int trial = 0; trial < 10; ++trial) {
        const auto states = random_states(2, 0.6, random);
        ElementResponse a, b;
        one->evaluate(states, Demand::Force, a);
        other->evaluate(states, Demand::Force, b);
        EXPECT_LT((a.force - b.force).norm(), 1e-11 * a.force.norm());
    }
}

TEST(BeamElement, ExchangingTheEndsChangesNothing) {
    Frame frame = one_beam();
    const auto forward = only_element(frame);
    std::swap(frame.nodes[0], frame.nodes[1]);
    frame.supports.clear();
    sample::clamp(frame, 1);
    const auto backward = only_element(frame);
    Random random(8);
    auto states = random_states(2, 0.5, random);
    ElementResponse a, b;
    forward->evaluate(states, Demand::Force, a);
    std::swap(states[0], states[1]);
    backward->evaluate(states, Demand::Force, b);
    EXPECT_LT((a.force.head<6>() - b.force.tail<6>()).norm(), 1e-11 * a.force.norm());
    EXPECT_LT((a.force.tail<6>() - b.force.head<6>()).norm(), 1e-11 * a.force.norm());
}

TEST(BeamElement, TranslationHasTheMassOfTheBeam) {
    const auto element = only_element(one_beam());
    MatrixXd mass;
    element->mass(mass);
    for (int c = 0; c < 3; ++c) {
        VectorXd motion = VectorXd::Zero(12);
        motion[c] = motion[c + 6] = 1.0;
        EXPECT_NEAR(motion.dot(mass * motion), 1240.0 * 6e-6 * kLength, 1e-15);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
