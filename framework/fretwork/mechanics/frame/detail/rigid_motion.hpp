// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <string>
#include <vector>

namespace fretwork::mechanics::detail {

/// For each node, the dofs that supports and prescribed displacements hold.
std::vector<DofSet> held_dofs(const Frame& frame);

/// A way in which a connected part of a structure can move without strain.
struct FreeMotion {
    NodeIndex node;           ///< a node of the part
    bool has_beam = true;     ///< false: the node has no beam
    std::string description;  ///< "move along (1, 0, 0)", "turn about (0, 0, 1)"
};

/// One free rigid motion of each connected part that is not held against all rigid motions. Hinges are
/// ignored.
std::vector<FreeMotion> free_rigid_motions(const Frame& frame, const std::vector<DofSet>& held);

}  // namespace fretwork::mechanics::detail
