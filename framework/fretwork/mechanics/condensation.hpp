// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace fretwork::mechanics {

/// The indices of nodes 0 .. count - 1.
std::vector<NodeIndex> first_nodes(int count);

/// Condense the linear stiffness of a structure onto the nodes `kept` (Schur complement). The result is exact
/// for small displacements if only the kept nodes have loads and supports. Loads and supports of the assembly
/// are ignored, except supports of hinges. Returns the 6n x 6n stiffness of the n kept nodes in the given
/// order: symmetric, positive semidefinite, rank 6n - 6 for a connected frame without hinges. Throws
/// InputError if a kept node does not exist or appears twice, NumericalError if the other nodes can move
/// without strain while the kept nodes are fixed.
Eigen::MatrixXd condense(const Assembly& assembly, std::span<const NodeIndex> kept);

/// Condense the consistent mass of a structure onto the nodes `kept`: the other nodes follow statically
/// [Guyan1965]. The result is exact for rigid motions. Natural frequencies are too high; the error is small
/// for frequencies far below those of the structure with its kept nodes fixed. Returns a symmetric 6n x 6n
/// matrix. Dense matrices limit the function to structures of some hundred nodes. Throws InputError as
/// condense(), and if the mass of an element is not known. Pre: the other nodes cannot move without strain
/// while the kept nodes are fixed.
Eigen::MatrixXd condense_mass(const Assembly& assembly, std::span<const NodeIndex> kept);

/// The matrix that maps motions of the kept nodes to the static motions of the other nodes: six rows for each
/// reported node that is not kept, in order, and six columns for each kept node. The matrix is exact if only
/// kept nodes have loads and supports. Dense matrices limit the function to structures of some hundred nodes.
/// Throws as condense().
Eigen::MatrixXd following(const Assembly& assembly, std::span<const NodeIndex> kept);

}  // namespace fretwork::mechanics
