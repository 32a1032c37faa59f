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
/// of the surface. A tile buckles if it has no stable equilibrium at some point of this motion, or if none is
/// found. Returns ascending indices.
///
/// @param solution  a solution with the interface nodes' rows first
///
/// Throws as TileBuilder does, and Stopped.
std::vector<tiling::TileIndex> buckled_tiles(const Surface& surface, const mechanics::Solution& solution,
                                             const SimulationOptions& options,
                                             const base::Control& control = {});

}  // namespace fretwork::simulation
