// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/mechanics/elements/corotational_element.hpp>
#include <fretwork/mechanics/elements/corotational_pose.hpp>

#include <string>

namespace fretwork::mechanics {
namespace {

/// The weight of rotations relative to displacements, per squared distance of the nodes from their mean.
/// Without rotations, the corotating axes of a slender tile, whose nodes lie nearly on a line, would be ill
/// defined.
constexpr double kRotationShare = 0.1;

/// The rounding of a condensed stiffness, as a share of its entries.
constexpr double kRigidForce = 1e-6;

void require_size(const char* name, const Eigen::MatrixXd& matrix, Eigen::Index nodes) {
    const Eigen::Index size = kDofsPerNode * nodes;
    if (matrix.rows() == size && matrix.cols() == size) return;
    throw base::InputError("a corotational element of " + std::to_string(nodes) + " nodes needs a " + name +
                           " of " + std::to_string(size) + " rows and columns, not " +
                           std::to_string(matrix.rows()) + " x " + std::to_string(matrix.cols()));
}

}  // namespace

CorotationalBody::CorotationalBody(Parts parts)
    : arms_(3, static_cast<Eigen::Index>(parts.nodes.size())),
      stiffness_(std::move(parts.stiffness)),
      mass_(std::move(parts.mass)) {
    if (parts.nodes.size() < 2)
        throw base::InputError("a corotational element needs two nodes or more, not " +
                               std::to_string(parts.nodes.size()));
    for (Eigen::Index i = 0; i < arms_.cols(); ++i) arms_.col(i) = parts.nodes[i];
    arms_.colwise() -= arms_.rowwise().mean().eval();
    require_size("stiffness", stiffness_, arms_.cols());
    const double square = arms_.squaredNorm() / static_cast<double>(arms_.cols());
    if (!(square > 0.0)) throw base::InputError("all nodes of a corotational element are at one place");
    rotation_weight_ = kRotationShare * square;
    Eigen::MatrixXd motions = geometry::rigid_motions(arms_);
    motions.rightCols<3>() /= std::sqrt(square);
    const double largest = (stiffness_ * motions).cwiseAbs().maxCoeff();
    const double entry = stiffness_.cwiseAbs().maxCoeff();
    if (!(largest <= kRigidForce * entry))
        throw base::InputError(
            "the stiffness of a corotational element resists a rigid motion: its force is " +
            base::format_number(largest / entry) + " of the largest entry, where rounding leaves " +
            base::format_number(kRigidForce) +
            " at most; the stiffness must be given in the axes of the nodes");
}

Eigen::MatrixXd CorotationalBody::mass() const {
    if (!mass_)
        throw base::InputError(
            "natural frequencies need the mass of every element, and a corotational one was made without");
    Eigen::MatrixXd mass = mass_();
    require_size("mass", mass, arms_.cols());
    return mass;
}

std::unique_ptr<const Element> corotational_element(std::vector<NodeIndex> nodes,
                                                    std::shared_ptr<const CorotationalBody> body,
                                                    const Eigen::Matrix3d& turn) {
    if (static_cast<Eigen::Index>(nodes.size()) != body->arms().cols())
        throw base::InputError("a corotational body of " + std::to_string(body->arms().cols()) +
                               " nodes cannot be placed on " + std::to_string(nodes.size()));
    return elements::make_corotational_element(std::move(nodes), std::move(body), turn);
}

std::optional<CorotationalMotion> corotational_motion(const CorotationalBody& body,
                                                      const Eigen::Matrix3d& turn,
                                                      std::span<const NodeState> states) {
    const Eigen::Quaterniond turned(turn);
    elements::CorotationalPose pose(body, turned, states);
    if (!pose.has_axes()) return std::nullopt;
    CorotationalMotion motion{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                              NodeValues(body.arms().cols(), kDofsPerNode)};
    for (std::size_t i = 0; i < pose.count(); ++i) {
        motion.shift += states[i].displacement / static_cast<double>(pose.count());
        auto row = motion.in_axes.row(static_cast<Eigen::Index>(i));
        row.head<3>() = (pose.arm(i) - pose.rest_arm(i)).transpose();
        row.tail<3>() = pose.rotation(i).transpose();
    }
    pose.turn_into_structure(turned);
    motion.axes = pose.axes();
    return motion;
}

}  // namespace fretwork::mechanics
