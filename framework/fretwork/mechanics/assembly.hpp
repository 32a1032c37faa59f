// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/element.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

#include <memory>
#include <vector>

namespace fretwork::mechanics {

/// The elements of a structure. Elements are immutable, and assemblies share them, so an edit replaces only
/// the elements that it changes.
using Elements = std::vector<std::shared_ptr<const Element>>;

/// The input of solvers: nodes, elements of any kind, supports, prescribed displacements and loads. Solvers
/// treat all elements alike, so one assembly may mix beams and condensed tiles.
struct Assembly {
    /// Rest positions, m; nodes inside beams and nodes of hinges come last.
    std::vector<Eigen::Vector3d> nodes;
    Elements elements;                               ///< beams and other elements
    std::vector<Support> supports;                   ///< supports: components that stay zero
    std::vector<PrescribedDisplacement> prescribed;  ///< components with given values
    /// Loads, one row for each node, gravity included. The row of a hinge's node is in the axes of its beam.
    NodeValues loads;
    bool has_moments = true;    ///< true if there are moments besides those of gravity
    int reported_nodes = 0;     ///< results have rows for nodes 0 .. reported_nodes - 1
    std::vector<int> labels{};  ///< labels of the reported nodes in messages; empty: their indices, from 0
};

/// Options of assemble().
struct AssemblyOptions {
    /// True: put half of each element's weight on each of its two ends, without the consistent moments.
    bool lumped_gravity = false;
    std::vector<int> node_labels{};  ///< labels of the frame's nodes in messages; empty: their indices, from
                                     ///< 0
    base::Control control{};         ///< stop; no progress is reported
};

/// Turn every beam of a frame into corotational Euler-Bernoulli elements or, with shear areas, Timoshenko
/// elements. A structure without supports is accepted: it can be condensed, but not solved. Throws as
/// validate(), and Stopped.
Assembly assemble(const Frame& frame, const AssemblyOptions& options = {});

}  // namespace fretwork::mechanics
