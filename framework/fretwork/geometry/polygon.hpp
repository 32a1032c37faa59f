// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace fretwork::geometry {

/// A point of the plane, in metres.
struct Point2 {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const Point2&, const Point2&) = default;
};

/// A simple polygon: its vertices counterclockwise, each once.
using Polygon = std::vector<Point2>;

/// The regular polygon around the origin in which the fan's sector t has the middle of its outer side at
/// angle 270 + 360 t / sides degrees, so vertex t lies at half a sector before that. `side` is the side
/// length in metres. Throws InputError unless sides >= 3 and side > 0.
Polygon regular_polygon(int sides, double side);

/// The signed area: positive for a counterclockwise polygon.
double signed_area(const Polygon& polygon);

/// The area centroid. Throws GeometryError if the area is zero.
Point2 centroid(const Polygon& polygon);

/// True if the polygon is counterclockwise and turns left (or goes straight) at every vertex. Decided
/// exactly.
bool is_convex(const Polygon& polygon);

/// Leave out points nearer than a distance to the one before them, the last beside the first as well. Files
/// say the same point twice where curves meet and where they close.
void remove_repeated_points(Polygon& polygon, double nearest);

/// The mean length of the sides.
double mean_side(const Polygon& polygon);

}  // namespace fretwork::geometry
