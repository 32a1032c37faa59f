// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace fretwork::mechanics {

/// Condense the linear stiffness of a structure onto some of its nodes (Schur complement): exact for small
/// displacements while only these nodes are loaded and held. Supports and loads of the assembly are left
/// aside. Returns the 6n x 6n matrix of the n nodes in the given order: symmetric, positive semidefinite,
/// rank 6n - 6 for a connected frame. Throws NumericalError if the inner nodes can move without strain while
/// the given ones are held.
Eigen::MatrixXd condense(const Assembly& assembly, std::span<const NodeIndex> kept);

}  // namespace fretwork::mechanics
