// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/session.hpp>

#include <span>
#include <vector>

namespace fretwork::simulation {

/// The model `mixed:SHARE`: corotational tiles, of which that share (rounded up) has all of its beams. These
/// are the tiles in which the corotational solution is worst: those of the largest products of energy and
/// largest rotation of a node against the tile's frame.

/// The tiles of the largest products of energy and rotation, worst first: `share` of them all, rounded up,
/// but none with a product of zero.
std::vector<tiling::TileIndex> worst_tiles(std::span<const TileDeformation> tiles, double share);

}  // namespace fretwork::simulation
