// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

#include <optional>

namespace fretwork::mechanics::structure {

/// A node that moves in a rigid motion of a connected part that supports and prescribed displacements leave
/// free, and that no element of the part resists. None if every part is held.
///
/// Places and supports decide, not numbers of stiffness, so the answer is the same for beams and for elements
/// to which they were condensed. Motions of a part of which an element is held by itself, such as a spring to
/// the ground, are left out.
std::optional<NodeIndex> freely_moving_node(const Assembly& assembly);

}  // namespace fretwork::mechanics::structure
