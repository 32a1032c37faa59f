// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/detail/dual.hpp>

namespace fretwork::tiling::detail {

/// Take away the triangles that are squeezed against the rim: such a triangle's side at the rim shrinks to a
/// point, and its two neighbours meet in one straight side, with one vertex less each. (These neighbours
/// mostly have seven sides: a triangle at the rim is where a row of hexagons ends.)
void collapse_rim_triangles(Dual& dual);

}  // namespace fretwork::tiling::detail
