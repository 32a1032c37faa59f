// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/element.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

#include <memory>
#include <vector>

namespace fretwork::mechanics {

/// Elements are immutable; assemblies share them, so that an edit replaces only those that it changes.
using Elements = std::vector<std::shared_ptr<const Element>>;

/// A structure as the solvers see it: nodes, elements of any kind, what is held, and what acts. Solvers never
/// ask what kind an element is; one assembly may mix beams and condensed tiles.
struct Assembly {
    std::vector<Eigen::Vector3d> nodes;  ///< rest positions, metres; those inside of beams and of hinges last
    Elements elements;
    std::vector<Support> supports;
    std::vector<PrescribedDisplacement> prescribed;
    NodeValues loads;           ///< one row a node, gravity included
    bool has_moments = true;    ///< moments among the loads, other than those of gravity
    int reported_nodes = 0;     ///< results have rows for nodes 0 .. this - 1
    std::vector<int> labels{};  ///< of the reported nodes, for messages; empty: their places, from 0
};

/// Options of the way from a frame to an assembly.
struct AssemblyOptions {
    bool lumped_gravity = false;     ///< half of a beam's weight on each end, without the consistent moments
    std::vector<int> node_labels{};  ///< how messages call the frame's nodes; empty: by their places, from 0
    base::Control control{};
};

/// Turn every beam into corotational Euler-Bernoulli (or, with shear areas, Timoshenko) elements. Throws as
/// validate(), and Stopped; but it takes a structure that is not held, which may be condensed, not solved.
Assembly assemble(const Frame& frame, const AssemblyOptions& options = {});

}  // namespace fretwork::mechanics
