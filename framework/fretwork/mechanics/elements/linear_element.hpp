// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>

#include <vector>

namespace fretwork::mechanics::elements {

/// The energy d . K d / 2 in the displacements and total rotation vectors of the nodes.
class LinearElement final : public Element {
  public:
    LinearElement(std::vector<NodeIndex> nodes, Eigen::MatrixXd stiffness)
        : nodes_(std::move(nodes)), stiffness_(std::move(stiffness)) {}

    [[nodiscard]] std::span<const NodeIndex> nodes() const override { return nodes_; }
    void rest_stiffness(Eigen::MatrixXd& stiffness) const override { stiffness = stiffness_; }
    void evaluate(std::span<const NodeState> states, Demand demand, ElementResponse& response) const override;

  private:
    std::vector<NodeIndex> nodes_;
    Eigen::MatrixXd stiffness_;
};

}  // namespace fretwork::mechanics::elements
