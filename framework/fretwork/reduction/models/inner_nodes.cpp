// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/reduction/models/inner_nodes.hpp>

#include <utility>

namespace fretwork::reduction {

InnerNodes::InnerNodes(mechanics::Frame tile, int interface_nodes)
    : tile_(std::move(tile)), interface_nodes_(interface_nodes) {}

std::span<const Eigen::Vector3d> InnerNodes::places() const {
    return std::span(tile_.nodes).subspan(interface_nodes_);
}

const Eigen::MatrixXd& InnerNodes::matrix() const {
    std::call_once(computed_, [this] {
        matrix_ = mechanics::following(mechanics::assemble(tile_), mechanics::first_nodes(interface_nodes_));
    });
    return matrix_;
}

mechanics::NodeValues InnerNodes::follow(const mechanics::NodeValues& interface_nodes) const {
    // The rows are stored one after the other, so together they form one column.
    mechanics::NodeValues moved(matrix().rows() / mechanics::kDofsPerNode, mechanics::kDofsPerNode);
    Eigen::Map<Eigen::VectorXd>(moved.data(), moved.size()).noalias() =
        matrix() * Eigen::Map<const Eigen::VectorXd>(interface_nodes.data(), interface_nodes.size());
    return moved;
}

mechanics::NodeValues InnerNodes::pull_back(const mechanics::NodeValues& inner_nodes) const {
    mechanics::NodeValues gradient(interface_nodes_, mechanics::kDofsPerNode);
    Eigen::Map<Eigen::VectorXd>(gradient.data(), gradient.size()).noalias() =
        matrix().transpose() * Eigen::Map<const Eigen::VectorXd>(inner_nodes.data(), inner_nodes.size());
    return gradient;
}

}  // namespace fretwork::reduction
