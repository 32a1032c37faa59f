// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/detail/system_layout.hpp>

#include <algorithm>

namespace fretwork::mechanics::detail {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

}  // namespace

SystemLayout::SystemLayout(const Assembly& assembly, const NodeGraph& graph, std::span<const DofSet> free,
                           std::span<const int> order) {
    number_equations(free, order);
    lay_out_columns(graph, order);
    place_elements(assembly);
}

void SystemLayout::number_equations(std::span<const DofSet> free, std::span<const int> order) {
    NodeEquations none;
    none.fill(-1);
    equation_.assign(free.size(), none);
    free_.assign(free.size(), {});
    for (const int node : order) {
        FreeDofs& dofs = free_[at(node)];
        dofs.first_equation = equations();
        for (int d = 0; d < kDofsPerNode; ++d) {
            if (!free[at(node)].contains[at(d)]) continue;
            equation_[at(node)][at(d)] = equations();
            dofs.dof[at(dofs.count++)] = d;
            node_of_.emplace_back(node);
        }
    }
}

void SystemLayout::lay_out_columns(const NodeGraph& graph, std::span<const int> order) {
    column_start_.reserve(node_of_.size() + 1);
    column_start_.push_back(0);
    std::vector<int> rows;
    for (const int node : order) {
        const FreeDofs& own = free_[at(node)];
        rows.clear();
        for (int k = graph.start[at(node)]; k < graph.start[at(node) + 1]; ++k) {
            const FreeDofs& other = free_[at(graph.neighbour[at(k)])];
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

/// The rows between the columns' own block and the coupling with another node.
int SystemLayout::block_offset(int column_node, int row_node) const {
    const FreeDofs& column = free_[at(column_node)];
    const auto begin = row_.begin() + column_start_[at(column.first_equation)] + column.count;
    const auto end = row_.begin() + column_start_[at(column.first_equation) + 1];
    return static_cast<int>(std::lower_bound(begin, end, free_[at(row_node)].first_equation) - begin);
}

void SystemLayout::place_elements(const Assembly& assembly) {
    element_start_.reserve(assembly.elements.size());
    for (const auto& element : assembly.elements) {
        const auto nodes = element->nodes();
        element_start_.push_back(pair_offset_.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            for (std::size_t j = i + 1; j < nodes.size(); ++j) {
                const FreeDofs& a = free_[at(nodes[i].value)];
                const FreeDofs& b = free_[at(nodes[j].value)];
                const bool coupled = a.count > 0 && b.count > 0;
                const bool a_first = a.first_equation < b.first_equation;
                pair_offset_.push_back(!coupled  ? -1
                                       : a_first ? block_offset(nodes[i].value, nodes[j].value)
                                                 : block_offset(nodes[j].value, nodes[i].value));
            }
        }
    }
}

void SystemLayout::add_diagonal(int node, const Eigen::Ref<const Eigen::MatrixXd>& block,
                                std::span<double> values) const {
    const FreeDofs& own = free_[at(node)];
    for (int column = 0; column < own.count; ++column) {
        double* target = values.data() + column_start_[at(own.first_equation + column)];
        const int j = own.dof[at(column)];
        for (int i = column; i < own.count; ++i) *target++ += block(own.dof[at(i)], j);
    }
}

void SystemLayout::add_coupling(int offset, std::array<int, 2> nodes,
                                const Eigen::Ref<const Eigen::MatrixXd>& block,
                                std::span<double> values) const {
    const bool straight = free_[at(nodes[0])].first_equation < free_[at(nodes[1])].first_equation;
    const FreeDofs& columns = free_[at(straight ? nodes[0] : nodes[1])];
    const FreeDofs& rows = free_[at(straight ? nodes[1] : nodes[0])];
    for (int column = 0; column < columns.count; ++column) {
        double* target = values.data() + column_start_[at(columns.first_equation + column)] +
                         (columns.count - column) + offset;
        const int j = columns.dof[at(column)];
        if (straight) {  // the block's rows are those of the first node; it is needed transposed
            for (int i = 0; i < rows.count; ++i) target[i] += block(j, rows.dof[at(i)]);
        } else {
            for (int i = 0; i < rows.count; ++i) target[i] += block(rows.dof[at(i)], j);
        }
    }
}

void SystemLayout::add(std::size_t element, std::span<const NodeIndex> nodes, const Eigen::MatrixXd& matrix,
                       std::span<double> values) const {
    const int* offset = pair_offset_.data() + element_start_[element];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i) * kDofsPerNode;
        add_diagonal(nodes[i].value, matrix.block<kDofsPerNode, kDofsPerNode>(row, row), values);
        for (std::size_t j = i + 1; j < nodes.size(); ++j, ++offset) {
            if (*offset < 0) continue;
            const auto column = static_cast<Eigen::Index>(j) * kDofsPerNode;
            add_coupling(*offset, {nodes[i].value, nodes[j].value},
                         matrix.block<kDofsPerNode, kDofsPerNode>(row, column), values);
        }
    }
}

void SystemLayout::gather(const NodeValues& table, Eigen::VectorXd& vector) const {
    vector.resize(equations());
    for (std::size_t node = 0; node < free_.size(); ++node) {
        const FreeDofs& own = free_[node];
        for (int i = 0; i < own.count; ++i)
            vector[own.first_equation + i] = table(static_cast<Eigen::Index>(node), own.dof[at(i)]);
    }
}

void SystemLayout::scatter(const Eigen::VectorXd& vector, NodeValues& table) const {
    for (std::size_t node = 0; node < free_.size(); ++node) {
        const FreeDofs& own = free_[node];
        for (int i = 0; i < own.count; ++i)
            table(static_cast<Eigen::Index>(node), own.dof[at(i)]) = vector[own.first_equation + i];
    }
}

}  // namespace fretwork::mechanics::detail
