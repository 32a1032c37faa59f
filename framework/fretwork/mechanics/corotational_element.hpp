// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace fretwork::mechanics {

/// The data that corotational elements of one shape share: immutable, so any number of elements and threads
/// may hold it. Everything is in the body's own axes.
class CorotationalBody {
  public:
    struct Parts {
        std::vector<Eigen::Vector3d> nodes;  ///< rest positions, m; the origin does not matter
        Eigen::MatrixXd stiffness;           ///< 6n x 6n, symmetric; no rigid motion meets a force
        /// Gives the consistent mass at rest, 6n x 6n, whenever it is asked for; empty: not known, and
        /// natural frequencies are refused.
        std::function<Eigen::MatrixXd()> mass{};
    };
    /// Throws InputError if the stiffness has another size than the nodes need, or resists a rigid motion.
    explicit CorotationalBody(Parts parts);

    [[nodiscard]] const Eigen::Matrix3Xd& arms() const { return arms_; }  ///< from the nodes' mean, m
    [[nodiscard]] const Eigen::MatrixXd& stiffness() const { return stiffness_; }
    /// The weight of a node's rotation against its displacement in the frame's turn, m^2.
    [[nodiscard]] double rotation_weight() const { return rotation_weight_; }
    /// Throws InputError if it is not known, or has another size than the nodes need.
    [[nodiscard]] Eigen::MatrixXd mass() const;

  private:
    Eigen::Matrix3Xd arms_;
    Eigen::MatrixXd stiffness_;
    double rotation_weight_ = 0.0;
    std::function<Eigen::MatrixXd()> mass_;
};

/// How the nodes of a corotational element lie in some states.
struct CorotationalMotion {
    Eigen::Matrix3d axes;   ///< from the body's axes as they turn with the nodes to the structure's
    Eigen::Vector3d shift;  ///< of the nodes' mean, m, in the structure's axes
    /// Displacements and rotation vectors that the frame leaves, in the body's axes as they turn with it.
    NodeValues in_frame{};
};
/// @param turn  the rotation from the body's axes to those of the structure
/// Nothing where the nodes have no frame: they are too far from any turn of their places at rest.
std::optional<CorotationalMotion> corotational_motion(const CorotationalBody& body,
                                                      const Eigen::Matrix3d& turn,
                                                      std::span<const NodeState> states);

/// An element of any number of nodes, such as a condensed tile, that moves and turns at will and answers
/// motions of its nodes against its corotating frame with its linear stiffness: see
/// framework/fretwork/mechanics/corotational.md. Its linearization at rest is the linear element of that
/// stiffness.
///
/// @param turn  the rotation from the body's axes to those of the structure
/// Throws InputError if the body has another number of nodes.
std::unique_ptr<const Element> corotational_element(std::vector<NodeIndex> nodes,
                                                    std::shared_ptr<const CorotationalBody> body,
                                                    const Eigen::Matrix3d& turn);

}  // namespace fretwork::mechanics
