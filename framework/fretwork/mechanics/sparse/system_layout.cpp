// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/index.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <algorithm>

namespace fretwork::mechanics::sparse {
namespace {

using base::at;

}  // namespace

SystemLayout::SystemLayout(const NodeGraph& graph, std::span<const Components> free,
                           std::span<const int> order, const base::Control& control)
    : cliques_(graph.cliques) {
    number_equations(free, order);
    lay_out_columns(graph, order, control);
    place_cliques(control);
}

void SystemLayout::number_equations(std::span<const Components> free, std::span<const int> order) {
    NodeEquations none;
    none.fill(-1);
    equation_.assign(free.size(), none);
    unknowns_.assign(free.size(), {});
    for (const int node : order) {
        NodeUnknowns& own = unknowns_[at(node)];
        own.first_equation = equations();
        for (int d = 0; d < kBlockSize; ++d) {
            if (!free[at(node)][at(d)]) continue;
            equation_[at(node)][at(d)] = equations();
            own.component[at(own.count++)] = d;
            node_of_.push_back(node);
        }
    }
}

void SystemLayout::lay_out_columns(const NodeGraph& graph, std::span<const int> order,
                                   const base::Control& control) {
    column_start_.reserve(node_of_.size() + 1);
    column_start_.push_back(0);
    std::vector<int> rows;
    for (const int node : order) {
        control.check();
        const NodeUnknowns& own = unknowns_[at(node)];
        rows.clear();
        for (int k = graph.start[at(node)]; k < graph.start[at(node) + 1]; ++k) {
            const NodeUnknowns& other = unknowns_[at(graph.neighbour[at(k)])];
            if (other.count == 0 || other.first_equation < own.first_equation) continue;
            for (int i = 0; i < other.count; ++i) rows.push_back(other.first_equation + i);
        }
        std::sort(rows.begin(), rows.end());
        for (int column = 0; column < own.count; ++column) {
            for (int i = column; i < own.count; ++i) row_.push_back(own.first_equation + i);
            row_.insert(row_.end(), rows.begin(), rows.end());
            column_start_.push_back(static_cast<int>(row_.size()));
        }
    }
}

/// The number of rows between a node's diagonal block and its coupling block with another node.
int SystemLayout::block_offset(int column_node, int row_node) const {
    const NodeUnknowns& column = unknowns_[at(column_node)];
    const auto begin = row_.begin() + column_start_[at(column.first_equation)] + column.count;
    const auto end = row_.begin() + column_start_[at(column.first_equation) + 1];
    return static_cast<int>(std::lower_bound(begin, end, unknowns_[at(row_node)].first_equation) - begin);
}

void SystemLayout::place_cliques(const base::Control& control) {
    pair_start_.reserve(cliques_.size());
    for (std::size_t clique = 0; clique < cliques_.size(); ++clique) {
        control.check();
        const auto nodes = cliques_[clique];
        pair_start_.push_back(pair_offset_.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            for (std::size_t j = i + 1; j < nodes.size(); ++j) {
                const NodeUnknowns& a = unknowns_[at(nodes[i])];
                const NodeUnknowns& b = unknowns_[at(nodes[j])];
                const bool coupled = a.count > 0 && b.count > 0;
                const bool a_first = a.first_equation < b.first_equation;
                pair_offset_.push_back(!coupled  ? -1
                                       : a_first ? block_offset(nodes[i], nodes[j])
                                                 : block_offset(nodes[j], nodes[i]));
            }
        }
    }
}

void SystemLayout::add_diagonal(int node, const Eigen::Ref<const Eigen::MatrixXd>& block,
                                std::span<double> values) const {
    const NodeUnknowns& own = unknowns_[at(node)];
    for (int column = 0; column < own.count; ++column) {
        double* target = values.data() + column_start_[at(own.first_equation + column)];
        const int j = own.component[at(column)];
        for (int i = column; i < own.count; ++i) *target++ += block(own.component[at(i)], j);
    }
}

void SystemLayout::add_coupling(int offset, std::array<int, 2> nodes,
                                const Eigen::Ref<const Eigen::MatrixXd>& block,
                                std::span<double> values) const {
    const bool straight = unknowns_[at(nodes[0])].first_equation < unknowns_[at(nodes[1])].first_equation;
    const NodeUnknowns& columns = unknowns_[at(straight ? nodes[0] : nodes[1])];
    const NodeUnknowns& rows = unknowns_[at(straight ? nodes[1] : nodes[0])];
    for (int column = 0; column < columns.count; ++column) {
        double* target = values.data() + column_start_[at(columns.first_equation + column)] +
                         (columns.count - column) + offset;
        const int j = columns.component[at(column)];
        if (straight) {  // the block's rows belong to the first node, so its transpose is needed
            for (int i = 0; i < rows.count; ++i) target[i] += block(j, rows.component[at(i)]);
        } else {
            for (int i = 0; i < rows.count; ++i) target[i] += block(rows.component[at(i)], j);
        }
    }
}

void SystemLayout::add(std::size_t clique, const Eigen::MatrixXd& matrix, std::span<double> values) const {
    const auto nodes = cliques_[clique];
    const int* offset = pair_offset_.data() + pair_start_[clique];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i) * kBlockSize;
        add_diagonal(nodes[i], matrix.block<kBlockSize, kBlockSize>(row, row), values);
        for (std::size_t j = i + 1; j < nodes.size(); ++j, ++offset) {
            if (*offset < 0) continue;
            const auto column = static_cast<Eigen::Index>(j) * kBlockSize;
            add_coupling(*offset, {nodes[i], nodes[j]}, matrix.block<kBlockSize, kBlockSize>(row, column),
                         values);
        }
    }
}

void SystemLayout::gather(const NodeTable& table, Eigen::VectorXd& vector) const {
    vector.resize(equations());
    for (std::size_t node = 0; node < unknowns_.size(); ++node) {
        const NodeUnknowns& own = unknowns_[node];
        for (int i = 0; i < own.count; ++i)
            vector[own.first_equation + i] = table(static_cast<Eigen::Index>(node), own.component[at(i)]);
    }
}

void SystemLayout::scatter(const Eigen::VectorXd& vector, NodeTable& table) const {
    for (std::size_t node = 0; node < unknowns_.size(); ++node) {
        const NodeUnknowns& own = unknowns_[node];
        for (int i = 0; i < own.count; ++i)
            table(static_cast<Eigen::Index>(node), own.component[at(i)]) = vector[own.first_equation + i];
    }
}

}  // namespace fretwork::mechanics::sparse
