// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <vector>

namespace fretwork::outlines::detail {

/// Join lines that nearly meet, so that the union of the loops has no slit and no needle narrower than
/// `width` (m). Corners nearer than `width` become one corner. A side nearer than `width` to a corner is bent
/// through that corner. A corner of less than a quarter of a degree is cut off where its sides are 2 `width`
/// apart. If corners or sides are to be joined, points nearer than `width` to the point before them are
/// removed first. Returns the number of changed corners and bent sides; if it is not zero, loops may touch
/// and cross each other.
int weld(const std::vector<geometry::Polygon*>& loops, double width);

}  // namespace fretwork::outlines::detail
