// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/detail/bezier.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

Point2 at(const Bezier& curve, double t) {
    const double s = 1 - t;
    return s * s * s * curve[0] + 3 * s * s * t * curve[1] + 3 * s * t * t * curve[2] + t * t * t * curve[3];
}

/// The largest number of pieces; a curve with more pieces is kilometres long.
constexpr double kMostPieces = 1e5;
/// The largest number of points of one polygon, 16 MB. A drawing may have 200,000 points, but SVG counts them
/// only when points that repeat are taken out.
constexpr std::size_t kMostFlattened = 1'000'000;

std::string place_of(const Bezier& curve) {
    return "a curve near (" + base::format_number(curve[0].x) + ", " + base::format_number(curve[0].y) +
           ") m";
}

/// The number of pieces that keeps the error below the tolerance. The error of a chord over a parameter step
/// h is at most h^2 / 8 times the largest second derivative, which is 6 times the larger second difference of
/// the control points.
int pieces_for_tolerance(const Bezier& curve, double tolerance) {
    const double bend =
        std::max(length(curve[0] - 2.0 * curve[1] + curve[2]), length(curve[1] - 2.0 * curve[2] + curve[3]));
    const double pieces = std::ceil(std::sqrt(0.75 * bend / tolerance));
    if (!(pieces <= kMostPieces))
        throw base::GeometryError(place_of(curve) + " is far too large for an outline; is the unit right?");
    return std::max(1, static_cast<int>(pieces));
}

}  // namespace

Bezier straight(Point2 from, Point2 to) {
    return {from, between(from, to, 1.0 / 3), between(from, to, 2.0 / 3), to};
}

std::vector<Bezier> beziers_of(const Arc& arc) {
    if (!std::isfinite(arc.sweep))
        throw base::GeometryError("the angle of an arc is not finite; are its numbers far too large?");
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / (std::numbers::pi / 6) - 1e-9)));
    const double step = arc.sweep / count;
    const double handle = 4.0 / 3 * std::tan(step / 4);
    const auto place = [&](double x, double y) { return arc.center + x * arc.axes[0] + y * arc.axes[1]; };
    std::vector<Bezier> curves;
    for (int i = 0; i < count; ++i) {
        const double t = arc.start + i * step;
        const double u = t + step;
        curves.push_back({place(std::cos(t), std::sin(t)),
                          place(std::cos(t) - handle * std::sin(t), std::sin(t) + handle * std::cos(t)),
                          place(std::cos(u) + handle * std::sin(u), std::sin(u) - handle * std::cos(u)),
                          place(std::cos(u), std::sin(u))});
    }
    return curves;
}

Polygon flatten(const Subpath& subpath, const Flattening& how) {
    Polygon polygon;
    for (const Bezier& piece : subpath.pieces) {
        Bezier curve;
        for (std::size_t i = 0; i < 4; ++i) curve[i] = how.to_metres(piece[i]);
        if (polygon.empty()) polygon.push_back(curve[0]);
        const int count = pieces_for_tolerance(curve, how.tolerance);
        if (polygon.size() + static_cast<std::size_t>(count) > kMostFlattened)
            throw base::GeometryError(place_of(curve) + " is part of a line of more than " +
                                      std::to_string(kMostFlattened) +
                                      " points, which is more than an outline can use; is the unit right?");
        for (int i = 1; i < count; ++i) polygon.push_back(at(curve, static_cast<double>(i) / count));
        polygon.push_back(curve[3]);
    }
    return polygon;
}

}  // namespace fretwork::outlines::detail
