// SPDX-License-Identifier: GPL-3.0-or-later
// Points of the plane as vectors.
#pragma once

#include <fretwork/pattern/polygon.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace fretwork::fabrication::detail {

using pattern::Point2;

inline Point2 operator+(const Point2& a, const Point2& b) {
    return {a.x + b.x, a.y + b.y};
}
inline Point2 operator-(const Point2& a, const Point2& b) {
    return {a.x - b.x, a.y - b.y};
}
inline Point2 operator*(double factor, const Point2& a) {
    return {factor * a.x, factor * a.y};
}
inline double dot(const Point2& a, const Point2& b) {
    return a.x * b.x + a.y * b.y;
}
inline double cross(const Point2& a, const Point2& b) {
    return a.x * b.y - a.y * b.x;
}
inline double norm(const Point2& a) {
    return std::hypot(a.x, a.y);
}
inline double distance(const Point2& a, const Point2& b) {
    return norm(b - a);
}
inline Point2 unit(const Point2& a) {
    return (1.0 / norm(a)) * a;
}
/// Turned by a quarter, counterclockwise.
inline Point2 left_of(const Point2& a) {
    return {-a.y, a.x};
}
inline Point2 direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
}
/// The point of a segment that is nearest to a place.
inline Point2 nearest_on_segment(const Point2& place, const Point2& from, const Point2& to) {
    const Point2 along = to - from;
    const double square = dot(along, along);
    const double share = square > 0.0 ? std::clamp(dot(place - from, along) / square, 0.0, 1.0) : 0.0;
    return from + share * along;
}

/// "(12.5, 3) mm"
std::string place_text(const Point2& place);

}  // namespace fretwork::fabrication::detail
