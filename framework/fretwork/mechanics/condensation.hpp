// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace fretwork::mechanics {

/// Nodes 0 .. count - 1 of a structure.
std::vector<NodeIndex> first_nodes(int count);

/// Condense the linear stiffness of a structure onto some of its nodes (Schur complement): exact for small
/// displacements while only these nodes are loaded and held. Supports and loads of the assembly are left
/// aside. Returns the 6n x 6n matrix of the n nodes in the given order: symmetric, positive semidefinite,
/// rank 6n - 6 for a connected frame. Throws NumericalError if the inner nodes can move without strain while
/// the given ones are held.
Eigen::MatrixXd condense(const Assembly& assembly, std::span<const NodeIndex> kept);

/// The consistent mass that goes with it: that of the structure in the displacements which those of the kept
/// nodes cause statically [Guyan1965]. Exact for rigid motions; natural frequencies come out too high, by the
/// less the farther they are below those of the structure with these nodes held. 6n x 6n, symmetric. For
/// structures of up to some hundred nodes: matrices are dense. Throws as condense, and InputError if an
/// element's mass is not known.
Eigen::MatrixXd condense_mass(const Assembly& assembly, std::span<const NodeIndex> kept);

/// How the other nodes follow the kept ones, statically: rows of six for each reported node that is not kept,
/// in their order, and columns of six for each kept one. Exact while only kept nodes are loaded and held. For
/// structures of up to some hundred nodes: matrices are dense. Throws as condense.
Eigen::MatrixXd following(const Assembly& assembly, std::span<const NodeIndex> kept);

}  // namespace fretwork::mechanics
