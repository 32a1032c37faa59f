// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/dual/dual.hpp>

namespace fretwork::tiling::detail {

/// A straight side on the rim, in the direction of its cell.
struct StraightSide {
    geometry::Point2 from;
    geometry::Point2 to;
};

/// Where a vertex may be that divides the side of a convex cell, so that the cell stays convex (decided
/// exactly): at the wanted place, or on the chord if that is on its left, inside the cell.
geometry::Point2 convex_place(geometry::Point2 wanted, const StraightSide& side);

/// The wanted sides of tiles.
struct WantedSides {
    const SizeField& field;
    double smallest;  ///< allowed, metres
};

/// Put a vertex on each side on the rim that is much longer than the sides usual there. Where an outline runs
/// along a row of hexagons, it cuts sides of sqrt(3) sides of a hexagon out of it; across the rows, sides of
/// 1 and 2. Their halves are nearer to the other sides. Cells have six sides at most afterwards, if they had
/// before. Throws base::Stopped.
void divide_long_rim_sides(Dual& dual, const Rim& rim, const WantedSides& wanted,
                           const base::Control& control);

}  // namespace fretwork::tiling::detail
