// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <span>
#include <vector>

namespace fretwork::simulation {

// In the model `mixed:SHARE`, the given share of the tiles (rounded up) have all of their beams, and all
// other tiles are corotational. The tiles with beams are the tiles in which the corotational solution is
// worst, judged by the product of the tile's energy and the largest rotation of a node relative to the tile's
// corotating axes.

/// The tiles with the largest products of energy and rotation, worst first. The number of these tiles is
/// `share` times the number of all tiles, rounded up; tiles with a product of zero are left out.
std::vector<tiling::TileIndex> worst_tiles(std::span<const TileDeformation> tiles, double share);
/// The worst tiles among the tiles without their own tile model, ascending. Tiles with their own tile model
/// keep it.
std::vector<tiling::TileIndex> worst_tiles(const Surface& surface, std::span<const TileDeformation> tiles,
                                           double share);

}  // namespace fretwork::simulation
