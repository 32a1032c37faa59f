// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/disjoint_sets.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/geometry/symmetric_eigen.hpp>
#include <fretwork/mechanics/frame/detail/rigid_motion.hpp>

#include <cmath>
#include <optional>

namespace fretwork::mechanics::detail {
namespace {

/// The nodes of each connected part; the parts come in the order of their first nodes.
std::vector<std::vector<std::size_t>> connected_parts(const Frame& frame) {
    base::DisjointSets nodes(frame.nodes.size());
    for (const Beam& beam : frame.beams) nodes.unite(beam.nodes[0], beam.nodes[1]);
    std::vector<std::vector<std::size_t>> members(frame.nodes.size());
    for (std::size_t i = 0; i < frame.nodes.size(); ++i) members[nodes.first_of(i)].push_back(i);
    std::erase_if(members, [](const auto& part) { return part.empty(); });
    return members;
}

std::string direction_text(Eigen::Vector3d direction) {
    direction.normalize();
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    if (direction[largest] < 0) direction = -direction;
    const auto rounded = [](double x) { return base::format_number(std::round(x * 1000.0) / 1000.0 + 0.0); };
    return "(" + rounded(direction.x()) + ", " + rounded(direction.y()) + ", " + rounded(direction.z()) + ")";
}

/// A rigid motion in words. It is a translation t of the center and a rotation w; w is multiplied by the
/// size, so both have the same unit.
std::string motion_text(const Eigen::Matrix<double, 6, 1>& motion) {
    const Eigen::Vector3d translation = motion.head<3>();
    const Eigen::Vector3d rotation = motion.tail<3>();
    if (rotation.norm() < 1e-3 * translation.norm()) return "move along " + direction_text(translation);
    return "turn about " + direction_text(rotation);
}

/// The nodes of a part relative to their mean, as shares of the largest distance from it.
Eigen::Matrix3Xd arms_of(const Frame& frame, const std::vector<std::size_t>& part) {
    Eigen::Matrix3Xd arms(3, std::ssize(part));
    for (std::size_t i = 0; i < part.size(); ++i) arms.col(i) = frame.nodes[part[i]];
    arms.colwise() -= arms.rowwise().mean().eval();
    const double size = arms.colwise().norm().maxCoeff();
    return size > 0.0 ? Eigen::Matrix3Xd(arms / size) : arms;
}

/// The sum over the held dofs of the squared motion of the dof, as a quadratic form of the rigid motion.
Eigen::Matrix<double, 6, 6> held_motion_form(const Frame& frame, const std::vector<std::size_t>& part,
                                             const std::vector<DofSet>& held) {
    const Eigen::MatrixXd motions = geometry::rigid_motions(arms_of(frame, part));
    Eigen::Matrix<double, 6, 6> form = Eigen::Matrix<double, 6, 6>::Zero();
    for (std::size_t i = 0; i < part.size(); ++i) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            if (!held[part[i]].contains[d]) continue;
            const auto row = motions.row(kDofsPerNode * static_cast<Eigen::Index>(i) + d);
            form += row.transpose() * row;
        }
    }
    return form;
}

std::optional<FreeMotion> free_motion(const Frame& frame, const std::vector<std::size_t>& part,
                                      const std::vector<DofSet>& held) {
    const geometry::SymmetricEigen eigen = geometry::symmetric_eigen(held_motion_form(frame, part, held));
    // The square of a ratio of lengths: displacements held at places closer together than a millionth of the
    // size hold no rotation.
    constexpr double kZero = 1e-12;
    if (eigen.values[0] > kZero) return std::nullopt;
    return FreeMotion{NodeIndex(part.front()), part.size() > 1, motion_text(eigen.vectors.col(0))};
}

}  // namespace

std::vector<DofSet> held_dofs(const Frame& frame) {
    std::vector<DofSet> held(frame.nodes.size());
    for (const Support& support : frame.supports) held[support.node] |= support.fixed;
    for (const PrescribedDisplacement& given : frame.prescribed) {
        held[given.node][given.dof] = true;
    }
    return held;
}

std::vector<FreeMotion> free_rigid_motions(const Frame& frame, const std::vector<DofSet>& held) {
    std::vector<FreeMotion> motions;
    for (const auto& part : connected_parts(frame)) {
        if (auto motion = free_motion(frame, part, held)) motions.push_back(std::move(*motion));
    }
    return motions;
}

}  // namespace fretwork::mechanics::detail
