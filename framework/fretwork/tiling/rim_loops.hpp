// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellation.hpp>

#include <vector>

namespace fretwork::tiling {

/// The interface nodes along the rim: of each closed line of sides that only one tile has, in the order in
/// which that tile's polygon runs (so the surface lies on the left), the outer boundary and each hole by
/// itself.
std::vector<std::vector<InterfaceIndex>> rim_loops(const Tessellation& tessellation);

}  // namespace fretwork::tiling
