// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

#include <string>
#include <vector>

namespace fretwork::mechanics::structure {

/// The supports of every node of an assembly, with their values.
struct Constraints {
    std::vector<DofSet> held;
    NodeValues values;  ///< zero where not prescribed
};

Constraints constraints_of(const Assembly& assembly);

/// The reported node that is nearest to a node of the assembly.
NodeIndex nearest_reported(const Assembly& assembly, NodeIndex node);

/// A node of the assembly as a person knows it: "node 3", or for an inner one "the inside of a beam at node
/// 3".
std::string node_text(const Assembly& assembly, NodeIndex node);

/// A typical length of the elements, m: what makes moments comparable to forces, and rotations to
/// displacements.
double characteristic_length(const Assembly& assembly);

/// Norm of a set of forces and moments in which a moment counts as the force on the characteristic length.
double force_norm(const NodeValues& forces, double length);

}  // namespace fretwork::mechanics::structure
