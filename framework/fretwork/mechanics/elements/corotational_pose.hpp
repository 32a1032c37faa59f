// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/corotational_element.hpp>

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace fretwork::mechanics::elements {

/// The positions and rotations of a corotational element's nodes relative to its corotating axes.
///
/// The rotation F of these axes is such that g = sum of P_i x u_i + weight theta_i vanishes. P_i is the arm
/// of node i at rest, u_i its displacement relative to the axes, and theta_i the rotation vector that remains
/// after F. All vectors are in the corotating axes, until turn_into_structure() expresses them in the
/// structure's axes.
class CorotationalPose {
  public:
    /// The pose at rest.
    explicit CorotationalPose(const CorotationalBody& body);

    /// The pose in given states of the nodes.
    /// @param turn  the rotation at rest from the body's axes to the structure's axes, a unit quaternion
    CorotationalPose(const CorotationalBody& body, const Eigen::Quaterniond& turn,
                     std::span<const NodeState> states);

    /// Express all vectors in the structure's axes.
    /// @param turn  the rotation at rest from the body's axes to the structure's axes
    void turn_into_structure(const Eigen::Quaterniond& turn);

    /// False if no corotating axes were found: the nodes are then too far from every rigid motion of their
    /// rest positions.
    [[nodiscard]] bool has_axes() const { return has_axes_; }
    [[nodiscard]] std::size_t count() const { return nodes_.size(); }
    /// The rotation from the corotating axes to the structure's axes; the identity before
    /// turn_into_structure().
    [[nodiscard]] const Eigen::Matrix3d& axes() const { return axes_; }
    /// The arm P_i of a node at rest, m.
    [[nodiscard]] const Eigen::Vector3d& rest_arm(std::size_t i) const { return nodes_[i].rest_arm; }
    /// The arm P_i + u_i of a node, m.
    [[nodiscard]] const Eigen::Vector3d& arm(std::size_t i) const { return nodes_[i].arm; }
    /// The rotation vector theta_i of a node, rad.
    [[nodiscard]] const Eigen::Vector3d& rotation(std::size_t i) const { return nodes_[i].rotation; }
    /// The map from spins of a node to changes of theta_i.
    [[nodiscard]] const Eigen::Matrix3d& inverse_map(std::size_t i) const { return nodes_[i].inverse_map; }
    /// The inverse of dg/dw, where w is a spin of the corotating axes.
    [[nodiscard]] const Eigen::Matrix3d& inverse_slope() const { return inverse_slope_; }

  private:
    struct Node {
        Eigen::Vector3d place;    ///< position relative to the mean of all nodes, in the body's axes at rest
        Eigen::Quaterniond turn;  ///< rotation of the node, in the body's axes at rest
        Eigen::Vector3d rest_arm;
        Eigen::Vector3d arm;
        Eigen::Vector3d rotation = Eigen::Vector3d::Zero();
        Eigen::Matrix3d inverse_map = Eigen::Matrix3d::Identity();
    };

    void place(const Eigen::Quaterniond& turn, std::span<const NodeState> states);
    void fit();
    void measure();
    void sum_up();

    double rotation_weight_;
    std::vector<Node> nodes_;
    Eigen::Quaterniond frame_ = Eigen::Quaterniond::Identity();
    Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
    Eigen::Vector3d offset_;
    Eigen::Matrix3d inverse_slope_;
    bool has_axes_ = true;
};

}  // namespace fretwork::mechanics::elements
