// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/results/solution.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

#include <vector>

namespace fretwork::simulation {

/// Find the tiles with beams that buckle between the interface nodes, which a reduced tile cannot show. Each
/// tile is solved alone, with all of its beams, while its interface nodes move to their places in a solution
/// of the surface. A tile buckles if its primary path does not reach the end of this motion, or is unstable
/// there. Returns ascending indices.
///
/// @param solution  a solution with the interface nodes' rows first
///
/// Throws InputError if a tile is not painted, and Stopped.
std::vector<tiling::TileIndex> buckled_tiles(const Surface& surface, const mechanics::Solution& solution,
                                             const SimulationOptions& options,
                                             const base::Control& control = {});

}  // namespace fretwork::simulation
