// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace fretwork::geometry {

/// A point of the plane, in metres.
struct Point2 {
    double x = 0.0;  ///< m
    double y = 0.0;  ///< m
    friend bool operator==(const Point2&, const Point2&) = default;
};

/// A simple polygon: its vertices in counterclockwise order, each listed once.
using Polygon = std::vector<Point2>;

/// The largest number of sides of a regular polygon, and of sectors of a fan (pattern::make_fan()).
inline constexpr int kMostPolygonSides = 10'000;

/// The regular polygon around the origin. The middle of side t lies at angle 270 + 360 t / sides degrees, so
/// vertex t lies at angle 270 + 360 (t - 1/2) / sides degrees. `side` is the side length in metres. Throws
/// InputError unless there are 3 to kMostPolygonSides sides, and `side` is a positive length within
/// base::kLengthLimits.
Polygon regular_polygon(int sides, double side);

/// The signed area, m^2: positive for a counterclockwise polygon.
double signed_area(const Polygon& polygon);

/// The area centroid. Throws GeometryError if the area is zero.
Point2 centroid(const Polygon& polygon);

/// True if the polygon is counterclockwise and turns left (or goes straight) at every vertex. The decision is
/// exact.
bool is_convex(const Polygon& polygon);

/// Remove each point that equals the last kept point or is nearer to it than `nearest` (m). Then remove such
/// points at the end, compared with the first. Files often repeat a point where curves meet or close.
void remove_repeated_points(Polygon& polygon, double nearest);

/// The mean length of the sides, m. Pre: there is at least one vertex.
double mean_side(const Polygon& polygon);

}  // namespace fretwork::geometry
