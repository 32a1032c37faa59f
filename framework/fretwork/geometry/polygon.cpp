// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/limits.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/polygon.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 kernel_point(const Point2& point) {
    return {point.x, point.y};
}

}  // namespace

Polygon regular_polygon(int sides, double side) {
    if (sides < 3 || sides > kMostPolygonSides)
        throw base::InputError("a regular polygon has 3 to " + std::to_string(kMostPolygonSides) +
                               " sides, and " + std::to_string(sides) + " were wanted");
    if (!base::is_positive_within(side, base::kLengthLimits))
        throw base::InputError("the side of a polygon is " + base::positive_range_text(base::kLengthLimits) +
                               ", and " + base::format_number(side) + " was wanted");
    const double half_sector = std::numbers::pi / sides;
    const double radius = side / (2.0 * std::sin(half_sector));
    Polygon polygon;
    for (int t = 0; t < sides; ++t) {
        const double angle = 1.5 * std::numbers::pi + (2 * t - 1) * half_sector;
        polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return polygon;
}

double signed_area(const Polygon& polygon) {
    double doubled = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2& a = polygon[i];
        const Point2& b = polygon[(i + 1) % polygon.size()];
        // Coordinates are relative to the first vertex, so a small polygon far from the origin keeps its
        // digits.
        doubled += (a.x - polygon[0].x) * (b.y - polygon[0].y) - (b.x - polygon[0].x) * (a.y - polygon[0].y);
    }
    return doubled / 2.0;
}

Point2 centroid(const Polygon& polygon) {
    const double area = signed_area(polygon);
    if (!(std::abs(area) > 0.0)) throw base::GeometryError("a polygon without area has no centroid");
    Point2 sum;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2& next = polygon[(i + 1) % polygon.size()];
        const Point2 a{polygon[i].x - polygon[0].x, polygon[i].y - polygon[0].y};
        const Point2 b{next.x - polygon[0].x, next.y - polygon[0].y};
        const double cross = a.x * b.y - b.x * a.y;
        sum.x += (a.x + b.x) * cross;
        sum.y += (a.y + b.y) * cross;
    }
    return {polygon[0].x + sum.x / (6.0 * area), polygon[0].y + sum.y / (6.0 * area)};
}

bool is_convex(const Polygon& polygon) {
    if (polygon.size() < 3) return false;
    bool turns = false;
    // Changes of the direction in x (in y where x is equal): two if convex, four in a star with two turns.
    int reversals = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto a = kernel_point(polygon[i]);
        const auto b = kernel_point(polygon[(i + 1) % polygon.size()]);
        const auto c = kernel_point(polygon[(i + 2) % polygon.size()]);
        const CGAL::Orientation turn = CGAL::orientation(a, b, c);
        if (turn == CGAL::RIGHT_TURN || a == b) return false;
        turns = turns || turn == CGAL::LEFT_TURN;
        if (CGAL::lexicographically_xy_smaller(a, b) != CGAL::lexicographically_xy_smaller(b, c)) ++reversals;
    }
    return turns && reversals == 2;
}

void remove_repeated_points(Polygon& polygon, double nearest) {
    const auto is_near = [&](const Point2& a, const Point2& b) {
        return a == b || std::hypot(a.x - b.x, a.y - b.y) < nearest;
    };
    polygon.erase(std::unique(polygon.begin(), polygon.end(), is_near), polygon.end());
    while (polygon.size() > 1 && is_near(polygon.front(), polygon.back())) polygon.pop_back();
}

double mean_side(const Polygon& polygon) {
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2& next = polygon[(i + 1) % polygon.size()];
        sum += std::hypot(next.x - polygon[i].x, next.y - polygon[i].y);
    }
    return sum / static_cast<double>(polygon.size());
}

}  // namespace fretwork::geometry
