// SPDX-License-Identifier: GPL-3.0-or-later
#include "element_kinds.hpp"

#include <fretwork/geometry/rotation.hpp>

#include <gtest/gtest.h>

#include <functional>

namespace fretwork::mechanics {
namespace THIS_TEST {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using sample::every_kind;
using sample::kLength;
using sample::random_states;
using sample::scaled;

/// A mixed response with the memory that it is written to.
struct Answer {
    MixedResponse response;
    VectorXd stress;
    MatrixXd slopes;
};

std::span<double> span_of(auto& values) {
    return {values.data(), static_cast<std::size_t>(values.size())};
}

Answer ask(const Element& element, const std::vector<NodeState>& states, const VectorXd& given,
           Demand demand = Demand::Tangent) {
    const auto size = static_cast<Eigen::Index>(states.size()) * kDofsPerNode;
    Answer answer{{}, VectorXd::Zero(given.size()), MatrixXd::Zero(given.size(), size)};
    const std::span<const double> in(given.data(), static_cast<std::size_t>(given.size()));
    element.evaluate_mixed(states, demand, {in, span_of(answer.stress), span_of(answer.slopes)},
                           answer.response);
    return answer;
}

VectorXd stresses_at(const Element& element, const std::vector<NodeState>& states) {
    return ask(element, states, VectorXd::Zero(element.stress_count()), Demand::Force).stress;
}

/// Displacements of the size of the element's own, but others.
VectorXd other_stresses(const Element& element, const std::vector<NodeState>& states,
                        sample::Random& random) {
    VectorXd stresses = stresses_at(element, states);
    for (double& stress : stresses) stress *= 2.0 * random.next();
    return stresses;
}

double step_of(int dof) {
    return 1e-5 * (dof < 3 ? kLength : 1.0);
}

/// Central differences along displacements and spins.
MatrixXd derivative(const std::vector<NodeState>& states,
                    const std::function<VectorXd(const std::vector<NodeState>&)>& function) {
    const auto size = static_cast<Eigen::Index>(states.size()) * kDofsPerNode;
    MatrixXd result(function(states).size(), size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const auto node = static_cast<std::size_t>(i / kDofsPerNode);
        const int dof = static_cast<int>(i % kDofsPerNode);
        auto plus = states;
        sample::move(plus[node], dof, step_of(dof));
        auto minus = states;
        sample::move(minus[node], dof, -step_of(dof));
        result.col(i) = (function(plus) - function(minus)) / (2.0 * step_of(dof));
    }
    return result;
}

TEST(MixedResponse, WithItsOwnStressesIsThePlainResponse) {
    for (const auto& [name, element] : every_kind()) {
        sample::Random random(11);
        const auto states = random_states(element->nodes().size(), 0.5, random);
        const Answer mixed = ask(*element, states, stresses_at(*element, states));
        ElementResponse plain;
        element->evaluate(states, Demand::Tangent, plain);
        EXPECT_DOUBLE_EQ(mixed.response.energy, plain.energy) << name;
        EXPECT_LT((mixed.response.force - plain.force).norm(), 1e-14 * plain.force.norm()) << name;
        EXPECT_LT((mixed.response.given_force - plain.force).norm(), 1e-14 * plain.force.norm()) << name;
        EXPECT_LT((mixed.response.tangent - plain.tangent).norm(), 1e-14 * plain.tangent.norm()) << name;
    }
}

TEST(MixedResponse, EnergyAndForceAreTrueWhateverStressesAreGiven) {
    for (const auto& [name, element] : every_kind()) {
        sample::Random random(12);
        const auto states = random_states(element->nodes().size(), 0.5, random);
        const Answer mixed = ask(*element, states, other_stresses(*element, states, random));
        ElementResponse plain;
        element->evaluate(states, Demand::Force, plain);
        EXPECT_DOUBLE_EQ(mixed.response.energy, plain.energy) << name;
        EXPECT_LT((mixed.response.force - plain.force).norm(), 1e-14 * plain.force.norm()) << name;
    }
}

TEST(MixedResponse, SlopesTurnMotionsIntoTheRatesOfTheStresses) {
    for (const auto& [name, element] : every_kind()) {
        if (element->stress_count() == 0) continue;
        sample::Random random(13);
        for (int trial = 0; trial < 10; ++trial) {
            const auto states = random_states(element->nodes().size(), 0.5, random);
            const Answer answer = ask(*element, states, stresses_at(*element, states));
            MatrixXd rates(answer.slopes.rows(), answer.slopes.cols());
            for (Eigen::Index column = 0; column < rates.cols(); ++column) {
                VectorXd strains = answer.slopes.col(column);
                VectorXd stresses(strains.size());
                element->stresses_of(span_of(strains), span_of(stresses));
                rates.col(column) = stresses;
            }
            const MatrixXd difference = derivative(
                states, [&](const std::vector<NodeState>& moved) { return stresses_at(*element, moved); });
            EXPECT_LT((rates - difference).norm(), 1e-8 * difference.norm()) << name;
        }
    }
}

TEST(MixedResponse, ForcesAreSlopesTimesStresses) {
    for (const auto& [name, element] : every_kind()) {
        if (element->stress_count() == 0) continue;
        sample::Random random(14);
        const auto states = random_states(element->nodes().size(), 0.5, random);
        const VectorXd given = other_stresses(*element, states, random);
        const Answer answer = ask(*element, states, given);
        const auto tolerance = 1e-13 * answer.response.force.norm();
        EXPECT_LT((answer.slopes.transpose() * answer.stress - answer.response.force).norm(), tolerance)
            << name;
        EXPECT_LT((answer.slopes.transpose() * given - answer.response.given_force).norm(), tolerance)
            << name;
    }
}

/// The tangent with given stresses is B^T K B and the derivative of B^T given. As for the true force, the
/// plain derivative along spins has a skew part: half of the node's moment.
TEST(MixedResponse, TangentHasTheGivenStressesInItsGeometricTerms) {
    for (const auto& [name, element] : every_kind()) {
        if (element->stress_count() == 0) continue;
        sample::Random random(15);
        for (int trial = 0; trial < 10; ++trial) {
            const auto states = random_states(element->nodes().size(), 0.5, random);
            const VectorXd given = other_stresses(*element, states, random);
            const Answer answer = ask(*element, states, given);
            EXPECT_LT((answer.response.tangent - answer.response.tangent.transpose()).norm(),
                      1e-12 * answer.response.tangent.norm());
            MatrixXd geometric = derivative(states, [&](const std::vector<NodeState>& moved) -> VectorXd {
                return ask(*element, moved, given, Demand::Force).response.given_force;
            });
            for (Eigen::Index at = 3; at < geometric.rows(); at += kDofsPerNode) {
                const Eigen::Vector3d moment = answer.response.given_force.segment<3>(at);
                geometric.block<3, 3>(at, at) += 0.5 * geometry::cross_matrix(moment);
            }
            MatrixXd material(answer.slopes.cols(), answer.slopes.cols());
            for (Eigen::Index column = 0; column < material.cols(); ++column) {
                VectorXd strains = answer.slopes.col(column);
                VectorXd stresses(strains.size());
                element->stresses_of(span_of(strains), span_of(stresses));
                material.col(column) = answer.slopes.transpose() * stresses;
            }
            const MatrixXd expected = scaled(material + geometric);
            EXPECT_LT((scaled(answer.response.tangent) - expected).norm(), 1e-8 * expected.norm()) << name;
        }
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics
