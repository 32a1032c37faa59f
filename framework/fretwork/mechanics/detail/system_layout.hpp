// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/detail/node_graph.hpp>

#include <array>
#include <span>
#include <vector>

namespace fretwork::mechanics::detail {

/// The equations of a structure in the order of their elimination, and where the stiffness of each element
/// goes in the lower triangle of their sparse matrix (compressed columns, rows ascending). Depends on what is
/// connected and held only; the numbers of a matrix are a plain vector that this class adds to.
class SystemLayout {
  public:
    /// @param free   the dofs of each node that are equations
    /// @param order  the nodes in their order of elimination
    SystemLayout(const Assembly& assembly, const NodeGraph& graph, std::span<const DofSet> free,
                 std::span<const int> order);

    [[nodiscard]] int equations() const { return static_cast<int>(node_of_.size()); }
    [[nodiscard]] const std::vector<int>& column_start() const { return column_start_; }
    [[nodiscard]] const std::vector<int>& row() const { return row_; }
    /// The equation of a dof, or -1.
    [[nodiscard]] int equation(int node, int dof) const {
        return equation_[static_cast<std::size_t>(node)][static_cast<std::size_t>(dof)];
    }
    [[nodiscard]] NodeIndex node_of(int equation) const {
        return node_of_[static_cast<std::size_t>(equation)];
    }

    /// Add an element's symmetric matrix to the values of the system's.
    void add(std::size_t element, std::span<const NodeIndex> nodes, const Eigen::MatrixXd& matrix,
             std::span<double> values) const;

    /// Add a symmetric 6 x 6 block to one node's diagonal.
    void add_node(int node, const Eigen::Ref<const Eigen::MatrixXd>& block, std::span<double> values) const {
        add_diagonal(node, block, values);
    }

    /// Pick the equations' components from a table, and put them back into it.
    void gather(const NodeValues& table, Eigen::VectorXd& vector) const;
    void scatter(const Eigen::VectorXd& vector, NodeValues& table) const;

  private:
    using NodeEquations = std::array<int, kDofsPerNode>;
    struct FreeDofs {
        int count = 0;
        int first_equation = 0;
        std::array<int, kDofsPerNode> dof{};
    };
    void number_equations(std::span<const DofSet> free, std::span<const int> order);
    void lay_out_columns(const NodeGraph& graph, std::span<const int> order);
    void place_elements(const Assembly& assembly);
    [[nodiscard]] int block_offset(int column_node, int row_node) const;
    void add_diagonal(int node, const Eigen::Ref<const Eigen::MatrixXd>& block,
                      std::span<double> values) const;
    void add_coupling(int offset, std::array<int, 2> nodes, const Eigen::Ref<const Eigen::MatrixXd>& block,
                      std::span<double> values) const;

    std::vector<NodeEquations> equation_;
    std::vector<FreeDofs> free_;
    std::vector<NodeIndex> node_of_;
    std::vector<int> column_start_;
    std::vector<int> row_;
    std::vector<std::size_t> element_start_;  ///< of an element's pairs in pair_offset_
    std::vector<int> pair_offset_;            ///< rows above a coupling block in its columns; -1: none
};

}  // namespace fretwork::mechanics::detail
