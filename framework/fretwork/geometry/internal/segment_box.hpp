// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <CGAL/Bbox_2.h>

#include <algorithm>

namespace fretwork::geometry {

/// The box around a segment, enlarged by `reach` (m) on each side. If two segments are nearer to each other
/// than twice `reach`, their boxes meet.
inline CGAL::Bbox_2 box_around(Point2 from, Point2 to, double reach) {
    const auto [left, right] = std::minmax(from.x, to.x);
    const auto [low, high] = std::minmax(from.y, to.y);
    return {left - reach, low - reach, right + reach, high + reach};
}

}  // namespace fretwork::geometry
