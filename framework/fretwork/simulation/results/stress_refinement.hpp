// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/session.hpp>

#include <vector>

namespace fretwork::simulation {

/// A solution whose largest stress lies where all beams are computed.
struct RefinedStress {
    SurfaceResult result;
    BeamTable table;
    std::vector<tiling::TileIndex> full_tiles;  ///< those with all of their beams, ascending
    int solutions = 0;                          ///< that it took
    /// Whether the tiles around the most stressed beam are in full; else no equilibrium was found on the way.
    bool is_settled = false;
};

/// A beam's tile, and the tiles that share an interface node with it, ascending.
std::vector<tiling::TileIndex> tiles_around(const Surface& surface, const BeamRow& beam);

/// Solves a session of reduced tiles again and again, and each time puts the tiles around the most stressed
/// beam in full, until they all are: reduced tiles smooth stresses, which peak at few places. The session
/// keeps these tile models.
///
/// @param full_tiles  to begin with
RefinedStress refine_stress(Session& session, std::vector<tiling::TileIndex> full_tiles,
                            const base::Control& control = {});

/// The same for a nonlinear result of corotational or mixed tiles that was read: from rest, along the primary
/// path, beginning with the result's own tiles in full. Throws InputError if the result is of another model,
/// linear, or one of stages.
RefinedStress refine_stress(const Surface& surface, const SurfaceResult& result,
                            const base::Control& control = {});

}  // namespace fretwork::simulation
