// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/mechanics/elements/rotation.hpp>

#include <Eigen/LU>

#include <limits>

namespace fretwork::mechanics::elements {

/// Sizes that the compiler knows, or (Eigen::Dynamic nodes) does not.
template <int Nodes>
struct CorotationalSizes {
    static constexpr int kDofs = Nodes == Eigen::Dynamic ? Eigen::Dynamic : kDofsPerNode * Nodes;
    using Points = Eigen::Matrix<double, 3, Nodes>;      ///< a column for each node
    using Vector = Eigen::Matrix<double, kDofs, 1>;      ///< displacements and rotations, node by node
    using Square = Eigen::Matrix<double, kDofs, kDofs>;  ///< a stiffness
    using Wide = Eigen::Matrix<double, 3, kDofs>;        ///< three rows of a derivative
    using Tall = Eigen::Matrix<double, kDofs, 3>;        ///< three columns of one
};

/// How the nodes of a corotational element lie against its frame.
///
/// The frame's turn F makes g = sum of P_i x u_i + weight theta_i vanish, where P_i are the arms at rest, u_i
/// the displacements and theta_i the rotation vectors that F leaves. All vectors are in the body's axes as
/// they turn with the frame, until turn_into_structure() gives them in the structure's axes.
template <int Nodes>
class CorotationalPose {
  public:
    using Points = typename CorotationalSizes<Nodes>::Points;

    /// At rest.
    explicit CorotationalPose(const CorotationalBody& body)
        : body_(body), places_(body.arms()), rest_arms_(body.arms()), arms_(body.arms()) {
        rotations_.setZero(3, count());
        inverse_maps_.resize(3, 3 * count());
        for (Eigen::Index i = 0; i < count(); ++i) inverse_maps_.template middleCols<3>(3 * i).setIdentity();
        sum_up();
    }

    /// @param turn  from the body's axes to the structure's, as a unit quaternion
    CorotationalPose(const CorotationalBody& body, const Eigen::Quaterniond& turn,
                     std::span<const NodeState> states)
        : CorotationalPose(body) {
        place(turn, states);
        fit();
    }

    /// @param turn  from the body's axes at rest to the structure's
    void turn_into_structure(const Eigen::Quaterniond& turn) {
        axes_ = (turn * frame_).toRotationMatrix();
        rest_arms_ = axes_.lazyProduct(rest_arms_).eval();
        arms_ = axes_.lazyProduct(arms_).eval();
        rotations_ = axes_.lazyProduct(rotations_).eval();
        for (Eigen::Index i = 0; i < count(); ++i)
            inverse_maps_.template middleCols<3>(3 * i) = turned(inverse_map(i));
        inverse_slope_ = turned(inverse_slope_);
    }

    /// False where no frame was found: the nodes are too far from any turn of their places at rest.
    [[nodiscard]] bool has_frame() const { return has_frame_; }
    [[nodiscard]] Eigen::Index count() const { return places_.cols(); }
    /// From the body's axes as they turn with the frame to those of the structure.
    [[nodiscard]] const Eigen::Matrix3d& axes() const { return axes_; }
    [[nodiscard]] auto rest_arm(Eigen::Index i) const { return rest_arms_.col(i); }  ///< P_i, m
    [[nodiscard]] auto arm(Eigen::Index i) const { return arms_.col(i); }            ///< P_i + u_i, m
    [[nodiscard]] auto rotation(Eigen::Index i) const { return rotations_.col(i); }  ///< theta_i
    /// From spins to changes of theta_i.
    [[nodiscard]] auto inverse_map(Eigen::Index i) const {
        return inverse_maps_.template middleCols<3>(3 * i);
    }
    /// The inverse of dg/dw, where w is a spin of the frame.
    [[nodiscard]] const Eigen::Matrix3d& inverse_slope() const { return inverse_slope_; }

  private:
    using Turns = Eigen::Matrix<double, 4, Nodes>;

    /// Nodes against their mean, in the body's axes at rest; the mean of their turns is the first guess.
    void place(const Eigen::Quaterniond& turn, std::span<const NodeState> states) {
        turns_.resize(4, count());
        Eigen::Vector4d mean = Eigen::Vector4d::Zero();
        for (Eigen::Index i = 0; i < count(); ++i) {
            const NodeState& state = states[static_cast<std::size_t>(i)];
            places_.col(i) += turn.conjugate() * state.displacement;
            const Eigen::Quaterniond own = turn.conjugate() * state.rotation * turn;
            turns_.col(i) = own.coeffs();
            mean += turns_.col(i).dot(turns_.col(0)) < 0.0 ? -own.coeffs() : own.coeffs();
        }
        places_.colwise() -= places_.rowwise().mean().eval();
        frame_ = Eigen::Quaterniond(mean);
        frame_.normalize();
    }

    /// Newton's method on g = 0. A step below the bound leaves an error of its square; in the forces that is
    /// multiplied by the strains, since the stiffness resists no turn.
    void fit() {
        constexpr int kMostSteps = 30;
        constexpr double kSmallStep = 1e-6;
        measure();
        for (int step = 0; step < kMostSteps; ++step) {
            const Eigen::Vector3d spin = -inverse_slope_ * offset_;
            if (!spin.allFinite()) break;
            frame_ = (frame_ * exponential(spin)).normalized();
            measure();
            if (spin.norm() < kSmallStep) return;
        }
        has_frame_ = false;
    }

    void measure() {
        const Eigen::Matrix3d back = frame_.toRotationMatrix().transpose();
        arms_ = back.lazyProduct(places_);
        const Eigen::Quaterniond inverse = frame_.conjugate();
        for (Eigen::Index i = 0; i < count(); ++i) {
            const LogarithmWithMap own =
                logarithm_with_map(inverse * Eigen::Quaterniond(Eigen::Vector4d(turns_.col(i))));
            rotations_.col(i) = own.rotation_vector;
            inverse_maps_.template middleCols<3>(3 * i) = own.inverse_spin_map;
        }
        sum_up();
    }

    /// g and dg/dw = sum of [P_i] [P_i + u_i] - weight T_i^-1.
    void sum_up() {
        offset_.setZero();
        Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
        for (Eigen::Index i = 0; i < count(); ++i) {
            const Eigen::Vector3d rest = rest_arm(i);
            const Eigen::Vector3d now = arm(i);
            offset_ += rest.cross(now) + body_.rotation_weight() * rotation(i);
            slope += now * rest.transpose() - body_.rotation_weight() * inverse_map(i);
            slope.diagonal().array() -= rest.dot(now);
        }
        inverse_slope_ = slope.inverse();
    }

    [[nodiscard]] Eigen::Matrix3d turned(const Eigen::Matrix3d& map) const {
        return axes_.lazyProduct(map.lazyProduct(axes_.transpose()).eval());
    }

    const CorotationalBody& body_;
    Points places_;  ///< from their mean, in the body's axes at rest
    Turns turns_;    ///< quaternions in these axes
    Eigen::Quaterniond frame_ = Eigen::Quaterniond::Identity();
    Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
    Points rest_arms_;
    Points arms_;
    Points rotations_;
    Eigen::Matrix<double, 3, Nodes == Eigen::Dynamic ? Eigen::Dynamic : 3 * Nodes> inverse_maps_;
    Eigen::Vector3d offset_;
    Eigen::Matrix3d inverse_slope_;
    bool has_frame_ = true;
};

}  // namespace fretwork::mechanics::elements
