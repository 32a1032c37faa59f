// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <span>
#include <vector>

namespace fretwork::simulation {

// In the model `mixed:SHARE`, the given share of the tiles (rounded up) have all of their beams, and all
// other tiles are corotational. Tiles get their beams where the corotational solution is worst. The measure
// is the tile's energy times the largest rotation of a node relative to the tile's corotating axes.

/// The worst `share` of the tiles (rounded up), worst first. Tiles with a measure of zero are left out.
std::vector<tiling::TileIndex> worst_tiles(std::span<const TileDeformation> tiles, double share);
/// The worst tiles among the tiles without their own tile model, ascending. `share` is a share of all tiles
/// of the surface, rounded up. Tiles with their own tile model keep it.
std::vector<tiling::TileIndex> worst_tiles(const Surface& surface, std::span<const TileDeformation> tiles,
                                           double share);

}  // namespace fretwork::simulation
