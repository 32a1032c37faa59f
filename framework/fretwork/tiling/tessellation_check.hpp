// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/tessellation.hpp>

namespace fretwork::tiling {

/// Check what every tessellation must obey, such as one that was read from a file: its layout's name, indices
/// in range, finite places, tiles that are convex and counterclockwise (decided exactly), sides that two
/// tiles at most share, in opposite directions, with the same interface nodes, interface nodes that lie on
/// their side at the layout's places and on no other side, patterns that are there, once each, and are
/// patterns of the layout, and nothing that no tile has (but patterns). Throws InputError or GeometryError
/// that names the tile.
void validate(const Tessellation& tessellation, const pattern::NodeLayout& layout);

}  // namespace fretwork::tiling
