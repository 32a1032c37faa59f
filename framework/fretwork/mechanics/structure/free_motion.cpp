// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/geometry/symmetric_eigen.hpp>
#include <fretwork/mechanics/structure/constraints.hpp>
#include <fretwork/mechanics/structure/free_motion.hpp>

#include <algorithm>
#include <map>
#include <vector>

namespace fretwork::mechanics::structure {
namespace {

using Matrix6 = Eigen::Matrix<double, kDofsPerNode, kDofsPerNode>;
using Vector6 = Eigen::Matrix<double, kDofsPerNode, 1>;

/// A motion is free if the squares of the held displacements add up to less than this share of the motion's
/// square: displacements held at places closer together than a millionth of the size hold no rotation. Frames
/// are checked in the same way (frame/detail/rigid_motion.cpp).
constexpr double kFreeSquare = 1e-12;

/// The largest work of a rigid motion that counts as rounding, as a share of the works that cancel. Rounding
/// of condensed tiles leaves up to 2e-7 (bars of 2 micrometres, reduction/detail/rigid_motions.cpp); an
/// element that is held by itself has about 1.
constexpr double kRoundingShare = 1e-6;

/// The rigid motions of one connected part: displacements of its middle, then rotations about it. Rotations
/// are multiplied by the part's size, so both have the same unit.
class RigidMotions {
  public:
    RigidMotions(const Assembly& assembly, const std::vector<NodeIndex>& part) : assembly_(assembly) {
        for (const NodeIndex node : part) middle_ += assembly.nodes[node] / static_cast<double>(part.size());
        for (const NodeIndex node : part) size_ = std::max(size_, (assembly.nodes[node] - middle_).norm());
        if (size_ == 0.0) size_ = 1.0;
    }

    /// The six rows of a node, for a column of each motion.
    [[nodiscard]] Matrix6 of(NodeIndex node) const {
        Matrix6 motions = geometry::rigid_motions(Eigen::Vector3d(assembly_.nodes[node] - middle_));
        motions.rightCols<3>() /= size_;
        return motions;
    }
    /// The same rows; those of rotations are multiplied by the part's size, so all rows have one unit.
    [[nodiscard]] Matrix6 in_one_unit(NodeIndex node) const {
        Matrix6 motions = of(node);
        motions.bottomRows<3>() *= size_;
        return motions;
    }

  private:
    const Assembly& assembly_;
    Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
    double size_ = 0.0;
};

class FreeMotionSearch {
  public:
    explicit FreeMotionSearch(const Assembly& assembly)
        : assembly_(assembly), held_(held_dofs(assembly)), sets_(connected_nodes(assembly)) {}

    std::optional<NodeIndex> run() {
        std::map<std::size_t, std::vector<NodeIndex>> parts;
        for (std::size_t node = 0; node < assembly_.nodes.size(); ++node)
            parts[sets_.first_of(node)].emplace_back(node);
        for (const auto& [first, part] : parts) {
            if (const auto node = moving_node(part)) return node;
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] bool is_reported(NodeIndex node) const { return node.value < assembly_.reported_nodes; }

    /// Supports of nodes that are not reported hold a hinge's own motions, and not the structure.
    [[nodiscard]] bool is_of_hinge(NodeIndex node) const {
        return !is_reported(node) && !(held_[node] == DofSet{});
    }

    std::optional<NodeIndex> moving_node(const std::vector<NodeIndex>& part) {
        const RigidMotions motions(assembly_, part);
        const geometry::SymmetricEigen eigen = geometry::symmetric_eigen(held_squares(part, motions));
        if (eigen.values[0] > kFreeSquare || is_held_by_an_element(part, motions)) return std::nullopt;
        const Vector6 free = eigen.vectors.col(0);
        NodeIndex farthest = part.front();
        double largest = 0.0;
        for (const NodeIndex node : part) {
            const double moved = (motions.of(node) * free).head<3>().norm();
            if (!is_reported(node) || moved <= largest) continue;
            largest = moved;
            farthest = node;
        }
        return farthest;
    }

    /// The sum of the squares of the held displacements, as a quadratic form of the rigid motions.
    [[nodiscard]] Matrix6 held_squares(const std::vector<NodeIndex>& part,
                                       const RigidMotions& motions) const {
        Matrix6 form = Matrix6::Zero();
        for (const NodeIndex node : part) {
            if (!is_reported(node) || held_[node] == DofSet{}) continue;
            const Matrix6 rows = motions.in_one_unit(node);
            for (int d = 0; d < kDofsPerNode; ++d) {
                if (held_[node].contains[d]) form += rows.row(d).transpose() * rows.row(d);
            }
        }
        return form;
    }

    /// True if an element of the part resists a rigid motion.
    bool is_held_by_an_element(const std::vector<NodeIndex>& part, const RigidMotions& motions) {
        const std::size_t first = sets_.first_of(part.front());
        return std::ranges::any_of(assembly_.elements, [&](const auto& element) {
            return sets_.first_of(element->nodes().front()) == first && resists(*element, motions);
        });
    }

    [[nodiscard]] bool resists(const Element& element, const RigidMotions& motions) const {
        const auto nodes = element.nodes();
        Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(kDofsPerNode * std::ssize(nodes), kDofsPerNode);
        for (Eigen::Index i = 0; i < std::ssize(nodes); ++i) {
            const NodeIndex node = nodes[static_cast<std::size_t>(i)];
            if (!is_of_hinge(node)) rows.middleRows<kDofsPerNode>(kDofsPerNode * i) = motions.of(node);
        }
        Eigen::MatrixXd stiffness;
        element.rest_stiffness(stiffness);
        const Vector6 work = rows.cwiseProduct(stiffness * rows).colwise().sum();
        const Vector6 cancelling =
            rows.cwiseAbs().cwiseProduct(stiffness.cwiseAbs() * rows.cwiseAbs()).colwise().sum();
        return (work.array() > kRoundingShare * cancelling.array()).any();
    }

    const Assembly& assembly_;
    std::vector<DofSet> held_;
    base::DisjointSets sets_;
};

}  // namespace

std::optional<NodeIndex> freely_moving_node(const Assembly& assembly) {
    return FreeMotionSearch(assembly).run();
}

}  // namespace fretwork::mechanics::structure
