// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/session.hpp>

#include <span>
#include <vector>

namespace fretwork::simulation::detail {

/// How far each tile is deformed in a solution of the assembly of joined tiles, whose elements begin where
/// `starts` says; zero for tiles made of beams.
std::vector<TileDeformation> tile_deformations(const mechanics::Assembly& assembly,
                                               std::span<const TileStart> starts,
                                               const mechanics::Solution& solution);

}  // namespace fretwork::simulation::detail
