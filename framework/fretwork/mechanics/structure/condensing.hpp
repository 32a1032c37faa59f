// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics::structure {

/// The kept and the eliminated unknowns of a structure.
struct CondensingTask {
    const Assembly& assembly;
    std::vector<int> slot;      ///< index of each node among the kept nodes; -1: eliminated
    std::vector<DofSet> inner;  ///< eliminated dofs of each node, without dofs that hinges do not release
    int kept_nodes = 0;
};

/// State the task of condensing an assembly. Throws InputError if a kept node does not exist or appears
/// twice.
CondensingTask condensing_task(const Assembly& assembly, std::span<const NodeIndex> kept);

/// The condensed stiffness by sparse elimination, for structures of any size. Throws NumericalError if the
/// inner nodes can move without strain.
Eigen::MatrixXd condense_sparse(const CondensingTask& task);

/// The condensed stiffness by dense elimination, which is faster for small structures. Membrane and bending
/// are eliminated separately if the structure is flat and its elements decouple. Throws as condense_sparse().
Eigen::MatrixXd condense_dense(const CondensingTask& task);

/// The condensed mass: the inner nodes follow the kept nodes statically. The matrices are dense. Pre: the
/// inner nodes cannot move without strain (checked by condense_dense()). Throws InputError if the mass of an
/// element is not known.
Eigen::MatrixXd condense_mass(const CondensingTask& task);

/// The matrix that maps motions of kept nodes to motions of inner nodes; see mechanics::following(). Throws
/// as condense_sparse().
Eigen::MatrixXd following(const CondensingTask& task);

/// Throw the NumericalError about inner nodes that can move without strain.
[[noreturn]] void refuse_inner_mechanism(const Assembly& assembly, NodeIndex node);

}  // namespace fretwork::mechanics::structure
