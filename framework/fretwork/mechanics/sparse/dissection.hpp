// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/node_graph.hpp>

#include <vector>

namespace fretwork::mechanics::sparse {

/// An order of elimination by nested dissection, from the places of the nodes [George1973]. Straight lines
/// halve the set of cliques repeatedly; the nodes shared by two halves come after both. In a surface of n
/// cliques, a line meets about sqrt(n) cliques. Two halves can be eliminated at the same time.
///
/// Pre: the graph has the places of its nodes. Throws Stopped.
/// @param takes_part  for each node, true if it appears in the order
std::vector<int> dissection_order(const NodeGraph& graph, const std::vector<bool>& takes_part,
                                  const base::Control& control = {});

}  // namespace fretwork::mechanics::sparse
