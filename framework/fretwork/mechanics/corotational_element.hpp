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

/// The data that corotational elements of one shape share, in the body's own axes. A body is immutable, so
/// any number of elements and threads may share it.
class CorotationalBody {
  public:
    /// The data from which a body is made.
    struct Parts {
        std::vector<Eigen::Vector3d> nodes;  ///< rest positions, m; the origin does not matter
        /// Stiffness at rest, 6n x 6n, symmetric; rigid motions cause no force.
        Eigen::MatrixXd stiffness;
        /// A function that computes the consistent mass at rest, 6n x 6n, at each call. Empty: the mass is
        /// not known, and natural frequencies are refused.
        std::function<Eigen::MatrixXd()> mass{};
    };
    /// Make a body. Throws InputError if there are not two nodes at different places, if the size of the
    /// stiffness does not fit the number of nodes, or if the stiffness resists a rigid motion.
    explicit CorotationalBody(Parts parts);

    /// The rest positions of the nodes relative to their mean, m.
    [[nodiscard]] const Eigen::Matrix3Xd& arms() const { return arms_; }
    /// The linear stiffness at rest, 6n x 6n for n nodes.
    [[nodiscard]] const Eigen::MatrixXd& stiffness() const { return stiffness_; }
    /// The weight of rotations relative to displacements in the equation for the corotating axes, m^2.
    [[nodiscard]] double rotation_weight() const { return rotation_weight_; }
    /// The consistent mass at rest, 6n x 6n. Throws InputError if the mass is not known, or if its size does
    /// not fit the number of nodes.
    [[nodiscard]] Eigen::MatrixXd mass() const;

  private:
    Eigen::Matrix3Xd arms_;
    Eigen::MatrixXd stiffness_;
    double rotation_weight_ = 0.0;
    std::function<Eigen::MatrixXd()> mass_;
};

/// The motion of a corotational element: its corotating axes, and the small displacements relative to these
/// axes.
struct CorotationalMotion {
    Eigen::Matrix3d axes;   ///< rotation from the corotating axes to the structure's axes
    Eigen::Vector3d shift;  ///< displacement of the nodes' mean, m, in the structure's axes
    /// Displacements and rotation vectors of the nodes relative to the corotating axes, in these axes.
    NodeValues in_axes{};
};
/// The motion of a corotational element in given states of its nodes. Nothing if no corotating axes exist:
/// the nodes are then too far from every rigid motion of their rest positions.
///
/// @param turn  the rotation at rest from the body's axes to the structure's axes
std::optional<CorotationalMotion> corotational_motion(const CorotationalBody& body,
                                                      const Eigen::Matrix3d& turn,
                                                      std::span<const NodeState> states);

/// An element of any number of nodes, such as a condensed tile, that may move and turn by any amount. Its
/// linear stiffness resists motions of its nodes relative to its corotating axes. The linearization at rest
/// is the linear element with that stiffness. The theory is in docs/concepts/corotational.md.
///
/// @param turn  the rotation at rest from the body's axes to the structure's axes
///
/// Throws InputError if the body has another number of nodes.
std::unique_ptr<const Element> corotational_element(std::vector<NodeIndex> nodes,
                                                    std::shared_ptr<const CorotationalBody> body,
                                                    const Eigen::Matrix3d& turn);

}  // namespace fretwork::mechanics
