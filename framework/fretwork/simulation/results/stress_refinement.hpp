// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/session.hpp>

#include <vector>

namespace fretwork::simulation {

/// The outcome of a refinement: a solution in which, if is_settled, all tiles around the largest stress have
/// all of their beams.
struct RefinedStress {
    SurfaceResult result;  ///< last solution, with the full tiles
    BeamTable table{};     ///< forces and stresses of the beams in the last solution that has converged
    std::vector<tiling::TileIndex> full_tiles{};  ///< tiles with all of their beams, ascending
    int solutions = 0;                            ///< number of solutions, the first one included
    /// True if all tiles around the most stressed beam have all of their beams. False if an equilibrium was
    /// not found or no stress is known.
    bool is_settled = false;
};

/// The tile of a beam and all painted tiles that share an interface node with this tile, ascending.
std::vector<tiling::TileIndex> tiles_around(const Surface& surface, const BeamRow& beam);

/// Solve a session of reduced tiles repeatedly, because stresses peak at few places, and reduced tiles smooth
/// the peaks. After each solution, the tiles around the most stressed beam get all of their beams. The
/// refinement ends if these tiles already have all of them, if a solution has not converged, or if no stress
/// is known. The session keeps the changed tile models. Throws as Session::solve().
///
/// @param full_tiles  the tiles with all of their beams in the first solution
RefinedStress refine_stress(Session& session, std::vector<tiling::TileIndex> full_tiles,
                            const base::Control& control = {});
/// Refine the stress as above, beginning with `first`, the last solution of the session, in which
/// `full_tiles` have all of their beams.
RefinedStress refine_stress(Session& session, SurfaceResult first, std::vector<tiling::TileIndex> full_tiles,
                            const base::Control& control = {});

/// Refine the stress of a nonlinear result of corotational or mixed tiles from a file. The first solution
/// starts from rest along the primary path, and has the same tiles with all of their beams as the result.
/// Throws InputError if the result has another model, is linear, or is a result of load stages; and as above.
/// Pre: the result has a subject.
RefinedStress refine_stress(const Surface& surface, const SurfaceResult& result,
                            const base::Control& control = {});

}  // namespace fretwork::simulation
