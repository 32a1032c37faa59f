// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/surface.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// A pair of bars that are too close to each other.
struct CloseBars {
    std::array<std::size_t, 2> bars;         ///< indices of the bars in SurfaceBeams
    std::array<tiling::TileIndex, 2> tiles;  ///< tile of each bar
    /// Distance between the edges of the bars, m; below zero if they overlap.
    double gap = 0.0;
};

/// All pairs of bars of a surface with a gap smaller than `clearance` (m; 0: pairs that overlap). The bars
/// have their width in the plane. Two bars that meet at a node always overlap there, so their gap is measured
/// between the far end of one bar and the other bar. Unpainted tiles have no bars. Throws InputError if
/// the clearance is negative or not finite; Stopped.
std::vector<CloseBars> close_bars(const Surface& surface, double clearance,
                                  const base::Control& control = {});

/// One line with the number of close pairs, the smallest gap or largest overlap, and at most eight of the
/// tiles; empty if there are no close pairs.
std::string close_bars_text(const std::vector<CloseBars>& close);

}  // namespace fretwork::simulation
