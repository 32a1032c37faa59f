// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

#include <vector>

namespace fretwork::mechanics::detail {

/// Which nodes are coupled by an element.
struct NodeGraph {
    int nodes = 0;
    std::vector<int> start;      ///< nodes + 1
    std::vector<int> neighbour;  ///< of node i: [start[i], start[i + 1]), ascending, both ways, i itself not
};

NodeGraph node_graph(const Assembly& assembly);

/// An order of elimination of little fill, of the nodes that take part; the others do not appear. The node
/// graph is ordered rather than the dofs' because it is six times smaller and gives better orders.
std::vector<int> elimination_order(const NodeGraph& graph, const std::vector<bool>& takes_part);

}  // namespace fretwork::mechanics::detail
