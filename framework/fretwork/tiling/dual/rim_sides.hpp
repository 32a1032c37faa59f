// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/dual/dual.hpp>

namespace fretwork::tiling::detail {

/// A straight side on the rim, in the direction of its cell.
struct StraightSide {
    geometry::Point2 from;
    geometry::Point2 to;
};

/// The place for a vertex that divides a side of a convex cell; by an exact test, the cell stays convex. If
/// the wanted place lies to the left of the side, and so inside the cell, the result is the nearest point of
/// the side, at least a tenth of the side from its ends. Otherwise it is the wanted place.
geometry::Point2 convex_place(geometry::Point2 wanted, const StraightSide& side);

/// The wanted sides of tiles, and the smallest side allowed.
struct WantedSides {
    const SizeField& field;
    double smallest;  ///< smallest side allowed, m
};

/// Put a vertex on each rim side that is much longer than the wanted side. Along a row of hexagons, an
/// outline makes rim sides of sqrt(3) times a hexagon's side; across the rows, it makes rim sides of 1 and 2
/// times a hexagon's side. Half of a long rim side is nearer to the length of the other sides. A cell with at
/// most six sides keeps at most six sides. Throws base::Stopped.
void divide_long_rim_sides(Dual& dual, const Rim& rim, const WantedSides& wanted,
                           const base::Control& control);

}  // namespace fretwork::tiling::detail
