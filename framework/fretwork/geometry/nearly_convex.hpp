// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <string>

namespace fretwork::geometry {

/// How far a vertex of a nearly convex polygon may lie inside of the line between its neighbours, as a share
/// of the polygon's shortest side: rounding to six digits bends straight corners so far.
inline constexpr double kInwardTolerance = 1e-4;

/// True if the polygon is convex (is_convex()), or becomes convex without some vertices that lie inside of
/// the line between their neighbours by no more than kInwardTolerance. Sectors around the centroid of such a
/// polygon do not overlap.
bool is_nearly_convex(const Polygon& polygon);

/// Where a counterclockwise polygon bends inwards most, for messages: ": it bends inwards at (0.5, 0.2) by
/// 0.001 m". Empty if it is clockwise or bends inwards nowhere.
std::string inward_bend_text(const Polygon& polygon);

}  // namespace fretwork::geometry
