// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/node_graph.hpp>

#include <array>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// The equations of coupled nodes in the order of their elimination, and the place of each clique's matrix in
/// the lower triangle of the sparse matrix (compressed columns, rows ascending). The layout depends only on
/// the couplings, the unknowns and the order. The values of a matrix are a plain vector, which this class
/// fills.
class SystemLayout {
  public:
    /// @param free   the components of each node that are unknowns; each unknown gives an equation
    /// @param order  the nodes that have unknowns, in their order of elimination
    ///
    /// Throws Stopped.
    SystemLayout(const NodeGraph& graph, std::span<const Components> free, std::span<const int> order,
                 const base::Control& control = {});

    [[nodiscard]] int equations() const { return static_cast<int>(node_of_.size()); }
    [[nodiscard]] const std::vector<int>& column_start() const { return column_start_; }
    [[nodiscard]] const std::vector<int>& row() const { return row_; }
    /// The equation of a node's component, or -1.
    [[nodiscard]] int equation(int node, int component) const { return equation_[node][component]; }
    [[nodiscard]] int node_of(int equation) const { return node_of_[equation]; }

    /// Add a clique's symmetric matrix, with kBlockSize rows for each node, to the values of the system's
    /// matrix.
    void add(std::size_t clique, const Eigen::MatrixXd& matrix, std::span<double> values) const;

    /// Add a symmetric block, kBlockSize x kBlockSize, to one node's diagonal block.
    void add_node(int node, const Eigen::Ref<const Eigen::MatrixXd>& block, std::span<double> values) const {
        add_diagonal(node, block, values);
    }

    /// Copy the equations' components from a table of nodes to a vector, which is resized. scatter() copies
    /// them back; all other components of its table stay.
    void gather(const NodeTable& table, Eigen::VectorXd& vector) const;
    void scatter(const Eigen::VectorXd& vector, NodeTable& table) const;

  private:
    using NodeEquations = std::array<int, kBlockSize>;
    struct NodeUnknowns {
        int count = 0;
        int first_equation = 0;
        std::array<int, kBlockSize> component{};
    };
    void number_equations(std::span<const Components> free, std::span<const int> order);
    void lay_out_columns(const NodeGraph& graph, std::span<const int> order, const base::Control& control);
    void place_cliques(const base::Control& control);
    [[nodiscard]] int block_offset(int column_node, int row_node) const;
    void add_diagonal(int node, const Eigen::Ref<const Eigen::MatrixXd>& block,
                      std::span<double> values) const;
    void add_coupling(int offset, std::array<int, 2> nodes, const Eigen::Ref<const Eigen::MatrixXd>& block,
                      std::span<double> values) const;

    Cliques cliques_;
    std::vector<NodeEquations> equation_;
    std::vector<NodeUnknowns> unknowns_;
    std::vector<int> node_of_;
    std::vector<int> column_start_;
    std::vector<int> row_;
    std::vector<std::size_t> pair_start_;  ///< start of each clique's pairs of nodes in `pair_offset_`
    /// Number of rows between the diagonal block and a pair's coupling block in its columns; -1: no block.
    std::vector<int> pair_offset_;
};

}  // namespace fretwork::mechanics::sparse
