// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/polygon.hpp>
#include <fretwork/tiling/outline.hpp>

#include <algorithm>
#include <cmath>

/// Arithmetic of points of the plane, and of what they bound.
namespace fretwork::tiling::detail {

using pattern::Point2;
using pattern::Polygon;

inline Point2 operator+(Point2 a, Point2 b) {
    return {a.x + b.x, a.y + b.y};
}
inline Point2 operator-(Point2 a, Point2 b) {
    return {a.x - b.x, a.y - b.y};
}
inline Point2 operator*(double factor, Point2 a) {
    return {factor * a.x, factor * a.y};
}
inline double dot(Point2 a, Point2 b) {
    return a.x * b.x + a.y * b.y;
}
/// The z component of the cross product: positive if b is to the left of a.
inline double cross(Point2 a, Point2 b) {
    return a.x * b.y - a.y * b.x;
}
inline double length(Point2 a) {
    return std::sqrt(a.x * a.x +
                     a.y * a.y);  // std::hypot is many times slower, and no outline needs its range
}
inline double distance(Point2 a, Point2 b) {
    return length(b - a);
}
/// The length of a closed polygon.
inline double perimeter(const Polygon& polygon) {
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += distance(polygon[i], polygon[(i + 1) % polygon.size()]);
    return sum;
}
/// Without its holes.
inline double area_of(const Outline& outline) {
    double area = pattern::signed_area(outline.boundary);
    for (const Polygon& hole : outline.holes) area += pattern::signed_area(hole);
    return area;
}
inline Point2 between(Point2 a, Point2 b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}
/// The point of the side from a to b (of some length) that is nearest to a point.
inline Point2 nearest_on_side(Point2 a, Point2 b, Point2 point) {
    const Point2 side = b - a;
    return between(a, b, std::clamp(dot(point - a, side) / dot(side, side), 0.0, 1.0));
}
/// The left-hand turn from direction a to direction b, in (-pi, pi].
inline double turn(Point2 a, Point2 b) {
    return std::atan2(cross(a, b), dot(a, b));
}

}  // namespace fretwork::tiling::detail
