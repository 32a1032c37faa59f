// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/elements/corotational_pose.hpp>

#include <Eigen/LU>

namespace fretwork::mechanics::elements {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

CorotationalPose::CorotationalPose(const CorotationalBody& body) : rotation_weight_(body.rotation_weight()) {
    const Eigen::Matrix3Xd& arms = body.arms();
    nodes_.resize(arms.cols());
    for (Eigen::Index i = 0; i < arms.cols(); ++i) {
        Node& node = nodes_[i];
        node.rest_arm = arms.col(i);
        node.place = node.arm = node.rest_arm;
    }
    sum_up();
}

CorotationalPose::CorotationalPose(const CorotationalBody& body, const Quaterniond& turn,
                                   std::span<const NodeState> states)
    : CorotationalPose(body) {
    place(turn, states);
    fit();
}

void CorotationalPose::turn_into_structure(const Quaterniond& turn) {
    axes_ = (turn * frame_).toRotationMatrix();
    const Matrix3d back = axes_.transpose();
    for (Node& node : nodes_) {
        node.rest_arm = axes_ * node.rest_arm;
        node.arm = axes_ * node.arm;
        node.rotation = axes_ * node.rotation;
        const Matrix3d half = node.inverse_map * back;
        node.inverse_map = axes_ * half;
    }
    const Matrix3d half = inverse_slope_ * back;
    inverse_slope_ = axes_ * half;
}

/// Set the nodes' positions relative to their mean, in the body's axes at rest. The mean of the nodes'
/// rotations is the first guess of the corotating axes.
void CorotationalPose::place(const Quaterniond& turn, std::span<const NodeState> states) {
    const Quaterniond back = turn.conjugate();
    Vector3d middle = Vector3d::Zero();
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < count(); ++i) {
        Node& node = nodes_[i];
        node.place += back * states[i].displacement;
        middle += node.place;
        node.turn = back * states[i].rotation * turn;
        const bool is_opposite = node.turn.coeffs().dot(nodes_.front().turn.coeffs()) < 0.0;
        if (is_opposite)
            mean -= node.turn.coeffs();
        else
            mean += node.turn.coeffs();
    }
    middle /= static_cast<double>(count());
    for (Node& node : nodes_) node.place -= middle;
    frame_ = Quaterniond(mean);
    frame_.normalize();
}

/// Solve g = 0 by Newton's method. A step below the bound leaves an error of the square of the step. In the
/// forces, this error is multiplied by the strains, because the stiffness resists no rigid rotation.
void CorotationalPose::fit() {
    constexpr int kMostSteps = 30;
    constexpr double kSmallStep = 1e-6;
    measure();
    for (int step = 0; step < kMostSteps; ++step) {
        const Vector3d spin = -inverse_slope_ * offset_;
        if (!spin.allFinite()) break;
        frame_ = (frame_ * geometry::exponential(spin)).normalized();
        measure();
        if (spin.norm() < kSmallStep) return;
    }
    has_axes_ = false;
}

void CorotationalPose::measure() {
    const Quaterniond inverse = frame_.conjugate();
    const Matrix3d back = inverse.toRotationMatrix();
    for (Node& node : nodes_) {
        node.arm = back * node.place;
        const geometry::LogarithmWithMap own = geometry::logarithm_with_map(inverse * node.turn);
        node.rotation = own.rotation_vector;
        node.inverse_map = own.inverse_spin_map;
    }
    sum_up();
}

/// Compute g and dg/dw = sum of [P_i] [P_i + u_i] - weight T_i^-1.
void CorotationalPose::sum_up() {
    offset_.setZero();
    Matrix3d slope = Matrix3d::Zero();
    for (const Node& node : nodes_) {
        offset_ += node.rest_arm.cross(node.arm);
        offset_ += rotation_weight_ * node.rotation;
        slope += node.arm * node.rest_arm.transpose();
        slope -= rotation_weight_ * node.inverse_map;
        slope.diagonal().array() -= node.rest_arm.dot(node.arm);
    }
    inverse_slope_ = slope.inverse();
}

}  // namespace fretwork::mechanics::elements
