// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/result_file.hpp>
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

/// A surface with corotational tiles, and with the worst of them in full.
struct MixedSolution {
    mechanics::Result corotational;
    /// Its `seconds` are those of both solutions. That of the corotational tiles if that has not converged.
    mechanics::Result mixed;
    std::vector<tiling::TileIndex> full_tiles;  ///< worst first
};

/// Solve a surface with corotational tiles, then with the worst `share` in full. Tiles with a model of their
/// own keep it. The options' model is left aside. The results have no subject. Throws as Session::solve.
MixedSolution solve_mixed(const Surface& surface, const LoadCase& load_case, SimulationOptions options,
                          double share, const base::Control& control = {});

}  // namespace fretwork::simulation
