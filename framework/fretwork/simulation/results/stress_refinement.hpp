// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/session.hpp>

#include <vector>

namespace fretwork::simulation {

/// A solution in which all tiles around the largest stress have all of their beams.
struct RefinedStress {
    SurfaceResult result;  ///< with the full tiles
    BeamTable table{};
    std::vector<tiling::TileIndex> full_tiles{};  ///< tiles with all of their beams, ascending
    int solutions = 0;                            ///< number of solutions needed
    /// True if the tiles around the most stressed beam are in full. False if an equilibrium was not found on
    /// the way.
    bool is_settled = false;
};

/// The tile of a beam, and the tiles that share an interface node with the beam's tile, ascending.
std::vector<tiling::TileIndex> tiles_around(const Surface& surface, const BeamRow& beam);

/// Solve a session of reduced tiles repeatedly. After each solution, the tiles around the most stressed beam
/// get all of their beams; the refinement ends if they have them already. It is needed because stresses peak
/// at few places, and reduced tiles smooth the peaks. The session keeps these tile models.
///
/// @param full_tiles  the tiles in full at the beginning
RefinedStress refine_stress(Session& session, std::vector<tiling::TileIndex> full_tiles,
                            const base::Control& control = {});
/// The same of a session whose last solution, with these tiles in full, is `first`: it is not solved again.
RefinedStress refine_stress(Session& session, SurfaceResult first, std::vector<tiling::TileIndex> full_tiles,
                            const base::Control& control = {});

/// Refine the stress of a nonlinear result of corotational or mixed tiles from a file. It solves from rest
/// along the primary path and begins with the result's own tiles in full. Throws InputError if the result has
/// another model, is linear, or is a result of load stages.
RefinedStress refine_stress(const Surface& surface, const SurfaceResult& result,
                            const base::Control& control = {});

}  // namespace fretwork::simulation
