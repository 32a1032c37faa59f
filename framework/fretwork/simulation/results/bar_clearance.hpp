// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/surface.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// Two bars that are too close to each other.
struct CloseBars {
    std::array<std::size_t, 2> bars;         ///< in the order of SurfaceBeams
    std::array<tiling::TileIndex, 2> tiles;  ///< the tile of each bar
    double gap = 0.0;                        ///< m between their edges, below zero if they overlap
};

/// The pairs of bars of a surface whose gap is smaller than `clearance` (m; 0: those that overlap), with the
/// width of the bars in the plane. Bars that meet at a node always overlap there: their gap is that between
/// the far end of one bar and the other bar. Tiles that are not painted have no bars. Throws Stopped.
std::vector<CloseBars> close_bars(const Surface& surface, double clearance,
                                  const base::Control& control = {});

/// One line with the number of close pairs and their places; empty if there are none.
std::string close_bars_text(const std::vector<CloseBars>& close);

}  // namespace fretwork::simulation
