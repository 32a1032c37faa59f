// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/structure/coupling.hpp>

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
    return sparse::node_graph(static_cast<int>(assembly.nodes.size()), std::move(cliques));
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
