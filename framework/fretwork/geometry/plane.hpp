// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <algorithm>
#include <array>
#include <cmath>

/// Arithmetic of plane vectors of type Point2.
namespace fretwork::geometry {

/// The sum of two vectors.
inline Point2 operator+(Point2 a, Point2 b) {
    return {a.x + b.x, a.y + b.y};
}
/// The vector from b to a.
inline Point2 operator-(Point2 a, Point2 b) {
    return {a.x - b.x, a.y - b.y};
}
/// The vector times a factor.
inline Point2 operator*(double factor, Point2 a) {
    return {factor * a.x, factor * a.y};
}
/// The scalar product.
inline double dot(Point2 a, Point2 b) {
    return a.x * b.x + a.y * b.y;
}
/// The z component of the cross product: positive if b is to the left of a.
inline double cross(Point2 a, Point2 b) {
    return a.x * b.y - a.y * b.x;
}
/// The length of a vector.
inline double length(Point2 a) {
    return std::sqrt(a.x * a.x +
                     a.y * a.y);  // std::hypot is many times slower, and no outline needs its range
}
/// The distance between two points, m.
inline double distance(Point2 a, Point2 b) {
    return length(b - a);
}
/// The unit vector in the direction of a vector, whose length must be above zero.
inline Point2 unit(Point2 a) {
    return (1.0 / length(a)) * a;
}
/// The vector turned by 90 degrees, counterclockwise.
inline Point2 left_of(Point2 a) {
    return {-a.y, a.x};
}
/// The unit vector at `angle` (rad) from the x axis.
inline Point2 direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
}
/// The angle from direction a to direction b, in [-pi, pi] rad; counterclockwise is positive.
inline double turn(Point2 a, Point2 b) {
    return std::atan2(cross(a, b), dot(a, b));
}
/// The point a + share (b - a).
inline Point2 between(Point2 a, Point2 b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}
/// The point of the segment from a to b that is nearest to `point`. The segment may have length zero.
inline Point2 nearest_on_segment(Point2 a, Point2 b, Point2 point) {
    const Point2 side = b - a;
    const double square = dot(side, side);
    const double share = square > 0.0 ? std::clamp(dot(point - a, side) / square, 0.0, 1.0) : 0.0;
    return between(a, b, share);
}
/// The straight line between two points.
using Segment = std::array<Point2, 2>;
/// True if the segments cross at a point that is an end of neither. Segments along one line do not cross.
inline bool do_cross(const Segment& a, const Segment& b) {
    const auto parts = [](const Segment& line, const Segment& ends) {
        const Point2 along = line[1] - line[0];
        return cross(along, ends[0] - line[0]) * cross(along, ends[1] - line[0]) < 0.0;
    };
    return parts(a, b) && parts(b, a);
}
/// The sum of the lengths of a polygon's sides, m.
inline double perimeter(const Polygon& polygon) {
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += distance(polygon[i], polygon[(i + 1) % polygon.size()]);
    return sum;
}

/// A circle with its inside.
struct Circle {
    Point2 center;        ///< m
    double radius = 0.0;  ///< m
    /// True for a point inside the circle or on it.
    [[nodiscard]] bool contains(Point2 point) const { return distance(center, point) <= radius; }
};

}  // namespace fretwork::geometry
