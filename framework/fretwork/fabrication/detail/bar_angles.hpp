// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/bar_plan.hpp>

#include <vector>

namespace fretwork::fabrication::detail {

/// An angle between neighbouring bars of a node.
struct BarAngle {
    double angle = 0.0;  ///< rad
    TessellationNodeIndex node;
    TileIndex tile;  ///< tile of one of the bars
};

/// The smallest angle between bars at every node with several bars, in ascending order.
std::vector<BarAngle> bar_angles(const BarPlan& plan);

/// Check that bars meet in nodes only. Throws GeometryError if two bars cross, touch (within a nanometre) or
/// lie over each other. The message names the tiles of the first such bars.
void require_no_crossings(const BarPlan& plan);

}  // namespace fretwork::fabrication::detail
