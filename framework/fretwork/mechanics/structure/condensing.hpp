// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

#include <span>
#include <vector>

namespace fretwork::mechanics::structure {

/// The kept and the eliminated unknowns of a structure.
struct CondensingTask {
    const Assembly& assembly;
    std::vector<int> slot;  ///< of each node: its place among the kept ones; -1: eliminated
    std::vector<DofSet>
        inner;  ///< of each node: the dofs to eliminate; those that hinges hold are not among them
    int kept_nodes = 0;
};

/// Throws InputError if a kept node does not exist or is named twice.
CondensingTask condensing_task(const Assembly& assembly, std::span<const NodeIndex> kept);

/// The condensed stiffness by sparse elimination, for structures of any size.
Eigen::MatrixXd condense_sparse(const CondensingTask& task);

/// The same by dense elimination: faster for small structures. Membrane and bending are apart where the
/// structure is flat and its elements decouple.
Eigen::MatrixXd condense_dense(const CondensingTask& task);

/// The mass of the kept nodes, where the inner ones follow them statically. By dense matrices. The inner
/// nodes cannot move without strain (as condense_dense has checked).
Eigen::MatrixXd condense_mass(const CondensingTask& task);

/// How the inner nodes follow the kept ones: mechanics::following.
Eigen::MatrixXd following(const CondensingTask& task);

/// Throws the NumericalError of inner nodes that can move without strain.
[[noreturn]] void refuse_inner_mechanism(const Assembly& assembly, NodeIndex node);

}  // namespace fretwork::mechanics::structure
