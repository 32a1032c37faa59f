// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/element.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

#include <memory>
#include <vector>

namespace fretwork::mechanics {

/// The elements of a structure. They are immutable, and assemblies share them, so an edit replaces only the
/// elements that it changes.
using Elements = std::vector<std::shared_ptr<const Element>>;

/// A structure in the form that solvers take: nodes, elements of any kind, supports, prescribed displacements
/// and loads. Solvers never ask for the kind of an element, so one assembly may mix beams and condensed
/// tiles.
struct Assembly {
    std::vector<Eigen::Vector3d> nodes;  ///< rest positions, m; the nodes inside beams and of hinges come
                                         ///< last
    Elements elements;                   ///< what resists
    std::vector<Support> supports;       ///< components that stay zero
    std::vector<PrescribedDisplacement> prescribed;  ///< components that are given
    NodeValues loads;                                ///< one row for each node, gravity included
    bool has_moments = true;    ///< true if the loads have moments other than those of gravity
    int reported_nodes = 0;     ///< results have rows for nodes 0 .. reported_nodes - 1
    std::vector<int> labels{};  ///< labels of the reported nodes in messages; empty: their indices, from 0
};

/// Options of assemble().
struct AssemblyOptions {
    bool lumped_gravity = false;     ///< put half of a beam's weight on each end, without the consistent
                                     ///< moments
    std::vector<int> node_labels{};  ///< labels of the frame's nodes in messages; empty: their indices, from
                                     ///< 0
    base::Control control{};         ///< how the caller follows and stops the work
};

/// Turn every beam into corotational Euler-Bernoulli (or, with shear areas, Timoshenko) elements. Throws as
/// validate(), and Stopped. A structure without supports is accepted, because it can be condensed, though not
/// solved.
Assembly assemble(const Frame& frame, const AssemblyOptions& options = {});

}  // namespace fretwork::mechanics
