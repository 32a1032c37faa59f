// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/linear_element.hpp>

#include <vector>

namespace fretwork::mechanics::elements {

/// A linear element, with the energy d . K d / 2, where d has the displacements and total rotation vectors of
/// its nodes.
class LinearElement final : public Element {
  public:
    LinearElement(std::vector<NodeIndex> nodes, LinearMatrices matrices)
        : nodes_(std::move(nodes)), matrices_(std::move(matrices)) {}

    [[nodiscard]] std::span<const NodeIndex> nodes() const override { return nodes_; }
    void rest_stiffness(Eigen::MatrixXd& stiffness) const override { stiffness = matrices_.stiffness; }
    void evaluate(std::span<const NodeState> states, Demand demand, ElementResponse& response) const override;
    /// Zero, because the element has linear strains.
    [[nodiscard]] Eigen::Index stress_count() const override { return 0; }
    void evaluate_mixed(std::span<const NodeState> states, Demand demand, const ElementStresses& stresses,
                        MixedResponse& response) const override;
    void stresses_of(std::span<const double>, std::span<double>) const override {}
    /// Zero, because the element is made for small rotations.
    [[nodiscard]] double relative_turn(std::span<const NodeState>) const override { return 0.0; }
    /// Zero, because the element's energy has no terms above the second order.
    void geometric_stiffness(const Eigen::VectorXd& displacements, Eigen::MatrixXd& stiffness) const override;
    void mass(Eigen::MatrixXd& mass) const override;

  private:
    std::vector<NodeIndex> nodes_;
    LinearMatrices matrices_;
};

}  // namespace fretwork::mechanics::elements
