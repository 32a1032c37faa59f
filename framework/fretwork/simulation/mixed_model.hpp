// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <span>
#include <vector>

namespace fretwork::simulation {

// The model `mixed:SHARE` has corotational tiles, but the given share of the tiles (rounded up) has all of
// its beams. These are the tiles in which the corotational solution is worst, judged by the product of the
// tile's energy and the largest rotation of a node relative to the tile's corotating axes.

/// The tiles with the largest products of energy and rotation, worst first. Their number is `share` of all
/// tiles, rounded up; a tile with a product of zero is left out.
std::vector<tiling::TileIndex> worst_tiles(std::span<const TileDeformation> tiles, double share);
/// The same of the tiles without a model of their own, which others keep; ascending.
std::vector<tiling::TileIndex> worst_tiles(const Surface& surface, std::span<const TileDeformation> tiles,
                                           double share);

}  // namespace fretwork::simulation
