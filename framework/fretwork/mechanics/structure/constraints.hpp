// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/disjoint_sets.hpp>
#include <fretwork/mechanics/assembly.hpp>

#include <string>
#include <vector>

namespace fretwork::mechanics::structure {

/// The held components of every node of an assembly: those that are supported or prescribed.
std::vector<DofSet> held_dofs(const Assembly& assembly);

/// The held components of every node of an assembly, and their values.
struct Constraints {
    std::vector<DofSet> held;
    NodeValues values;  ///< prescribed values; zero for other components
};

Constraints constraints_of(const Assembly& assembly);

/// The nodes of an assembly; those that elements connect are in one set.
base::DisjointSets connected_nodes(const Assembly& assembly);

/// The reported node that is nearest to a node of the assembly.
NodeIndex nearest_reported(const Assembly& assembly, NodeIndex node);

/// The name of a node in messages: "node 3", or "the inside or hinge of a beam at node 3" for a node inside a
/// beam or of a hinge.
std::string node_text(const Assembly& assembly, NodeIndex node);

/// A typical length of the elements, m, which makes moments comparable to forces, and rotations to
/// displacements; 1 if no element has a length.
double characteristic_length(const Assembly& assembly);

/// The norm of forces and moments. A moment counts as its force at the lever arm `length`.
double force_norm(const NodeValues& forces, double length);

}  // namespace fretwork::mechanics::structure
