// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/plane.hpp>

namespace fretwork::geometry {

/// The number of counterclockwise turns of a closed polygon around a point; clockwise turns count negative.
/// The polygon may cross itself.
inline int winding_number(const Polygon& polygon, Point2 point) {
    int winding = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 a = polygon[i];
        const Point2 b = polygon[(i + 1) % polygon.size()];
        if ((a.y <= point.y) == (b.y <= point.y)) continue;
        const double side = cross(b - a, point - a);
        if (b.y > a.y && side > 0) ++winding;
        if (b.y <= a.y && side < 0) --winding;
    }
    return winding;
}

}  // namespace fretwork::geometry
