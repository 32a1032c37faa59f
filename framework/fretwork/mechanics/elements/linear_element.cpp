// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/elements/linear_element.hpp>

#include <Eigen/LU>

namespace fretwork::mechanics::elements {

void LinearElement::evaluate(std::span<const NodeState> states, Demand demand,
                             ElementResponse& response) const {
    const Eigen::Index size = matrices_.stiffness.rows();
    const auto count = static_cast<Eigen::Index>(nodes_.size());
    Eigen::VectorXd d(size);
    for (Eigen::Index i = 0; i < count; ++i) {
        const NodeState& state = states[i];
        d.segment<3>(i * kDofsPerNode) = state.displacement;
        d.segment<3>(i * kDofsPerNode + 3) = geometry::logarithm(state.rotation);
    }
    response.force.noalias() = matrices_.stiffness * d;
    response.energy = 0.5 * d.dot(response.force);
    if (demand == Demand::Tangent) response.tangent = matrices_.stiffness;
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Index at = i * kDofsPerNode + 3;
        const Eigen::Vector3d rotation = d.segment<3>(at);
        const Eigen::Matrix3d inverse = geometry::spin_map(rotation).inverse();
        const Eigen::Vector3d moment = inverse.transpose() * response.force.segment<3>(at);
        response.force.segment<3>(at) = moment;
        if (demand == Demand::Force) continue;
        // In components of the rotation vector, K = T^T K_spin T + d(T^T m)/d(theta). This is solved for
        // K_spin.
        Eigen::Matrix3d change = geometry::spin_map_derivative(rotation, moment);
        change = 0.5 * (change + change.transpose()).eval();
        response.tangent.block<3, 3>(at, at) -= change;
        response.tangent.middleCols<3>(at) = (response.tangent.middleCols<3>(at) * inverse).eval();
        response.tangent.middleRows<3>(at) =
            (inverse.transpose() * response.tangent.middleRows<3>(at)).eval();
    }
}

void LinearElement::evaluate_mixed(std::span<const NodeState> states, Demand demand, const ElementStresses&,
                                   MixedResponse& response) const {
    evaluate(states, demand, response);
    response.given_force = response.force;
}

void LinearElement::geometric_stiffness(const Eigen::VectorXd& displacements,
                                        Eigen::MatrixXd& stiffness) const {
    stiffness.setZero(displacements.size(), displacements.size());
}

void LinearElement::mass(Eigen::MatrixXd& mass) const {
    if (matrices_.mass.size() == 0)
        throw base::InputError(
            "natural frequencies need the mass of every element, and a linear element was made without one");
    mass = matrices_.mass;
}

}  // namespace fretwork::mechanics::elements
