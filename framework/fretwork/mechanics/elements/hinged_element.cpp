// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/elements/hinged_element.hpp>

namespace fretwork::mechanics::elements {
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr Eigen::Index kBeamDofs = Eigen::Index{2} * kDofsPerNode;

HingedElement::HingedEnd HingedElement::compose(const Matrix3d& axes, const NodeState& node,
                                                const NodeState& hinge) {
    HingedEnd end;
    end.turned_axes = node.rotation.toRotationMatrix() * axes;
    end.arm = end.turned_axes * hinge.displacement;
    end.state.displacement = node.displacement + end.arm;
    const Eigen::Quaterniond frame(axes);
    end.state.rotation = node.rotation * frame * hinge.rotation * frame.conjugate();
    end.state.rotation.normalize();
    return end;
}

HingedElement::HingedElement(std::unique_ptr<const BeamElement> beam, const std::array<NodeIndex, 2>& hinges)
    : beam_(std::move(beam)), nodes_(beam_->nodes().begin(), beam_->nodes().end()) {
    for (Eigen::Index end = 0; end < 2; ++end) {
        if (!hinges[end].is_valid()) continue;
        hinges_.push_back({end, std::ssize(nodes_)});
        nodes_.push_back(hinges[end]);
    }
}

/// The map from small motions of this element's nodes to small motions of the beam's ends.
Eigen::MatrixXd HingedElement::rest_map() const {
    Eigen::MatrixXd map = Eigen::MatrixXd::Zero(kBeamDofs, size());
    map.leftCols(kBeamDofs).setIdentity();
    for (const Hinge& hinge : hinges_) {
        for (Eigen::Index part = 0; part < 2; ++part)
            map.block<3, 3>(6 * hinge.end + 3 * part, 6 * hinge.slot + 3 * part) = beam_->geometry().axes;
    }
    return map;
}

void HingedElement::rest_stiffness(Eigen::MatrixXd& stiffness) const {
    Eigen::MatrixXd own;
    beam_->rest_stiffness(own);
    const Eigen::MatrixXd map = rest_map();
    stiffness = map.transpose() * own * map;
}

void HingedElement::mass(Eigen::MatrixXd& mass) const {
    Eigen::MatrixXd own;
    beam_->mass(own);
    const Eigen::MatrixXd map = rest_map();
    mass = map.transpose() * own * map;
}

HingedElement::Hung HingedElement::hang(std::span<const NodeState> states) const {
    Hung hung{{states[0], states[1]}, {}, rest_map()};
    for (const Hinge& hinge : hinges_) {
        const std::size_t end = hinge.end;
        HingedEnd& hinged = hung.hinged[end];
        hinged = compose(beam_->geometry().axes, states[end], states[hinge.slot]);
        hung.ends[end] = hinged.state;
        hung.map.block<3, 3>(6 * hinge.end, 6 * hinge.end + 3) = -geometry::cross_matrix(hinged.arm);
        for (Eigen::Index part = 0; part < 2; ++part)
            hung.map.block<3, 3>(6 * hinge.end + 3 * part, 6 * hinge.slot + 3 * part) = hinged.turned_axes;
    }
    return hung;
}

void HingedElement::evaluate(std::span<const NodeState> states, Demand demand,
                             ElementResponse& response) const {
    const Hung hung = hang(states);
    ElementResponse own;
    beam_->evaluate(hung.ends, demand, own);
    response.energy = own.energy;
    response.force = hung.map.transpose() * own.force;
    if (demand == Demand::Force) return;
    response.tangent = hung.map.transpose() * own.tangent * hung.map;
    add_hinge_curvature(own.force, hung.hinged, response.tangent);
}

void HingedElement::evaluate_mixed(std::span<const NodeState> states, Demand demand,
                                   const ElementStresses& stresses, MixedResponse& response) const {
    const Hung hung = hang(states);
    Eigen::Matrix<double, Eigen::Dynamic, kBeamDofs> slopes(stress_count(), kBeamDofs);
    MixedResponse own;
    beam_->evaluate_mixed(
        hung.ends, demand,
        {stresses.given, stresses.own, {slopes.data(), static_cast<std::size_t>(slopes.size())}}, own);
    response.energy = own.energy;
    response.force = hung.map.transpose() * own.force;
    response.given_force = hung.map.transpose() * own.given_force;
    if (demand == Demand::Force) return;
    response.tangent = hung.map.transpose() * own.tangent * hung.map;
    add_hinge_curvature(own.given_force, hung.hinged, response.tangent);
    Eigen::Map<Eigen::MatrixXd>(stresses.slopes.data(), slopes.rows(), size()) = slopes * hung.map;
}

double HingedElement::relative_turn(std::span<const NodeState> states) const {
    return beam_->relative_turn(hang(states).ends);
}

void HingedElement::geometric_stiffness(const Eigen::VectorXd& displacements,
                                        Eigen::MatrixXd& stiffness) const {
    const Eigen::MatrixXd map = rest_map();
    const Eigen::VectorXd beam_displacements = map * displacements;
    Eigen::MatrixXd own;
    beam_->rest_stiffness(own);
    const Eigen::VectorXd force = own * beam_displacements;
    beam_->geometric_stiffness(beam_displacements, own);
    stiffness = map.transpose() * own * map;
    const HingedEnd at_rest = compose(beam_->geometry().axes, {}, {});
    add_hinge_curvature(force, {at_rest, at_rest}, stiffness);
}

void HingedElement::add_hinge_curvature(const Eigen::VectorXd& force, const std::array<HingedEnd, 2>& hinged,
                                        Eigen::MatrixXd& tangent) const {
    for (const Hinge& hinge : hinges_) {
        const std::size_t end = hinge.end;
        const Vector3d pull = force.segment<3>(6 * hinge.end);
        const Vector3d moment = force.segment<3>(6 * hinge.end + 3);
        const Matrix3d& turned = hinged[end].turned_axes;
        const Vector3d& arm = hinged[end].arm;
        const Eigen::Index spin = 6 * hinge.end + 3;
        const Eigen::Index slide = 6 * hinge.slot;
        // For a spin w of the frame's node, a slide s and a turn h of the hinge: the second-order terms of
        // exp(w) (arm + s), and the term w x h / 2 of exp(w) exp(h).
        Matrix3d lever = 0.5 * (pull * arm.transpose() + arm * pull.transpose());
        lever.diagonal().array() -= pull.dot(arm);
        tangent.block<3, 3>(spin, spin) += lever;
        const Matrix3d follow = -geometry::cross_matrix(pull) * turned;
        tangent.block<3, 3>(spin, slide) += follow;
        tangent.block<3, 3>(slide, spin) += follow.transpose();
        const Matrix3d commute = -0.5 * geometry::cross_matrix(moment) * turned;
        tangent.block<3, 3>(spin, slide + 3) += commute;
        tangent.block<3, 3>(slide + 3, spin) += commute.transpose();
    }
}

}  // namespace fretwork::mechanics::elements
