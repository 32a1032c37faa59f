// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/node_graph.hpp>

#include <vector>

namespace fretwork::mechanics::sparse {

/// An order of elimination by nested dissection, by the places of the nodes [George1973]: cliques are halved
/// along straight lines, again and again, and the nodes that two halves share come after both. Of a surface
/// of n cliques each line meets about sqrt(n), and the halves can be eliminated at the same time.
///
/// @param takes_part  for each node; the others do not appear
/// The graph has places. Throws Stopped.
std::vector<int> dissection_order(const NodeGraph& graph, const std::vector<bool>& takes_part,
                                  const base::Control& control = {});

}  // namespace fretwork::mechanics::sparse
