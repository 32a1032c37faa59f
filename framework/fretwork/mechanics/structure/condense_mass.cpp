// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/structure/condensing.hpp>

#include <Eigen/Cholesky>

#include <algorithm>

namespace fretwork::mechanics::structure {
namespace {

/// The row of each dof in matrices with the kept dofs first; -1: held by a hinge.
std::vector<Eigen::Index> rows_of(const CondensingTask& task) {
    Eigen::Index next = Eigen::Index{kDofsPerNode} * task.kept_nodes;
    std::vector<Eigen::Index> rows;
    for (std::size_t node = 0; node < task.slot.size(); ++node) {
        for (std::size_t d = 0; d < kDofsPerNode; ++d) {
            if (task.slot[node] >= 0) {
                rows.push_back(task.slot[node] * kDofsPerNode + static_cast<Eigen::Index>(d));
            } else {
                rows.push_back(task.inner[node].contains[d] ? next++ : -1);
            }
        }
    }
    return rows;
}

void add(std::span<const NodeIndex> nodes, std::span<const Eigen::Index> rows, const Eigen::MatrixXd& own,
         Eigen::MatrixXd& sum) {
    std::vector<Eigen::Index> places;
    for (const NodeIndex node : nodes) {
        for (int d = 0; d < kDofsPerNode; ++d) places.push_back(rows[node.value * kDofsPerNode + d]);
    }
    for (std::size_t j = 0; j < places.size(); ++j) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i] >= 0 && places[j] >= 0)
                sum(places[i], places[j]) += own(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
    }
}

}  // namespace

Eigen::MatrixXd condense_mass(const CondensingTask& task) {
    const std::vector<Eigen::Index> rows = rows_of(task);
    const Eigen::Index kept = Eigen::Index{kDofsPerNode} * task.kept_nodes;
    const Eigen::Index size = std::max(kept, rows.empty() ? 0 : 1 + *std::ranges::max_element(rows));
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
    Eigen::MatrixXd mass = stiffness;
    Eigen::MatrixXd own;
    for (const auto& element : task.assembly.elements) {
        element->rest_stiffness(own);
        add(element->nodes(), rows, own, stiffness);
        element->mass(own);
        add(element->nodes(), rows, own, mass);
    }
    const Eigen::Index inner = size - kept;
    if (inner == 0) return mass;
    // The matrix by which the inner dofs follow the kept dofs statically.
    const Eigen::LDLT<Eigen::MatrixXd> factors(stiffness.bottomRightCorner(inner, inner));
    const Eigen::MatrixXd follow = -factors.solve(stiffness.bottomLeftCorner(inner, kept));
    const Eigen::MatrixXd coupling = mass.topRightCorner(kept, inner) * follow;
    return mass.topLeftCorner(kept, kept) + coupling + coupling.transpose() +
           follow.transpose() * mass.bottomRightCorner(inner, inner) * follow;
}

}  // namespace fretwork::mechanics::structure
