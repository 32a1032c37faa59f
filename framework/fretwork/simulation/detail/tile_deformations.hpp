// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/session.hpp>

#include <span>
#include <vector>

namespace fretwork::simulation::detail {

/// The deformation of each tile in a solution of the assembly of joined tiles; zero for tiles made of beams.
/// Throws Stopped.
/// @param starts  JoinedTiles::starts
std::vector<TileDeformation> tile_deformations(const mechanics::Assembly& assembly,
                                               std::span<const TileStart> starts,
                                               const mechanics::Solution& solution,
                                               const base::Control& control = {});

}  // namespace fretwork::simulation::detail
