// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/nonlinear/unknowns.hpp>

namespace fretwork::mechanics {

/// Choose the rotation vectors of an equilibrium whose way from rest is not known. The vectors of a rotation
/// differ by whole turns. Each node gets the vector that continues along the elements, with less than half a
/// turn in each element, from the nearest node whose rotation is held. Nodes with a prescribed component of
/// rotation keep their vector. In a part of the structure without such nodes, the vector of one node, which
/// is supported if any node is, has a length of at most pi. The rotations themselves are unchanged.
void continue_along_elements(const nonlinear::Unknowns& unknowns, nonlinear::Configuration& configuration);

}  // namespace fretwork::mechanics
