// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/sparse/node_graph.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics::structure {

// The couplings of a structure that the sparse solver needs.

static_assert(sparse::kBlockSize == kDofsPerNode);

/// The graph of an assembly's nodes. The cliques of the graph are the elements, in their order.
sparse::NodeGraph coupling_graph(const Assembly& assembly);

/// An element's stiffness (6n x 6n) with its nodes in the order `wanted`. Every block comes from the upper
/// triangle of `stiffness`, because a layout reads that triangle. So sums have the same bits in any order of
/// the nodes.
Eigen::MatrixXd reordered(const Eigen::MatrixXd& stiffness, std::span<const NodeIndex> nodes,
                          std::span<const int> wanted);

/// The components of each node that are unknowns, if `dofs` are the unknowns.
std::vector<sparse::Components> components(std::span<const DofSet> dofs);
/// The components of each node that are unknowns, if all but `dofs` are unknowns.
std::vector<sparse::Components> other_components(std::span<const DofSet> dofs);

}  // namespace fretwork::mechanics::structure
