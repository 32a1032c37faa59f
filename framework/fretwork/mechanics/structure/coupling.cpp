// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/structure/coupling.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::mechanics::structure {

sparse::NodeGraph coupling_graph(const Assembly& assembly) {
    sparse::Cliques cliques;
    std::vector<int> nodes;
    for (const auto& element : assembly.elements) {
        nodes.clear();
        for (const NodeIndex node : element->nodes()) nodes.push_back(node.value);
        cliques.add(nodes);
    }
    sparse::NodeGraph graph = sparse::node_graph(static_cast<int>(assembly.nodes.size()), std::move(cliques));
    graph.places.assign(assembly.nodes.begin(), assembly.nodes.end());
    return graph;
}

Eigen::MatrixXd reordered(const Eigen::MatrixXd& stiffness, std::span<const NodeIndex> nodes,
                          std::span<const int> wanted) {
    std::vector<Eigen::Index> first_row;  // first row of each wanted node in the given stiffness
    for (const int node : wanted)
        first_row.push_back(kDofsPerNode * (std::ranges::find(nodes, NodeIndex(node)) - nodes.begin()));
    Eigen::MatrixXd result(stiffness.rows(), stiffness.cols());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        for (std::size_t j = 0; j < wanted.size(); ++j) {
            const auto row = std::min(first_row[i], first_row[j]);
            const auto column = std::max(first_row[i], first_row[j]);
            const auto block = stiffness.block<kDofsPerNode, kDofsPerNode>(row, column);
            auto target = result.block<kDofsPerNode, kDofsPerNode>(
                static_cast<Eigen::Index>(i) * kDofsPerNode, static_cast<Eigen::Index>(j) * kDofsPerNode);
            if (first_row[i] <= first_row[j]) {
                target = block;
            } else {
                target = block.transpose();
            }
        }
    }
    return result;
}

std::vector<sparse::Components> components(std::span<const DofSet> dofs) {
    std::vector<sparse::Components> result;
    result.reserve(dofs.size());
    for (const DofSet& set : dofs) result.push_back(set.contains);
    return result;
}

std::vector<sparse::Components> other_components(std::span<const DofSet> dofs) {
    std::vector<sparse::Components> result = components(dofs);
    for (sparse::Components& set : result) {
        for (bool& component : set) component = !component;
    }
    return result;
}

}  // namespace fretwork::mechanics::structure
