// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/surface.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// Two bars that come too near to each other.
struct CloseBars {
    std::array<std::size_t, 2> bars;         ///< in the order of SurfaceBeams
    std::array<tiling::TileIndex, 2> tiles;  ///< that they are of
    double gap = 0.0;                        ///< m between their rims, below zero where they overlap
};

/// The bars of a surface whose rims are nearer than `clearance` (m, 0: those that overlap), with the width
/// that they have in the plane. Bars that meet at a node overlap there by their nature: of these the gap is
/// that between the far end of one and the other. Tiles that are not painted have no bars. Throws Stopped.
std::vector<CloseBars> close_bars(const Surface& surface, double clearance,
                                  const base::Control& control = {});

/// One line with the number of such places, and where they are; empty if there are none.
std::string close_bars_text(const std::vector<CloseBars>& close);

}  // namespace fretwork::simulation
