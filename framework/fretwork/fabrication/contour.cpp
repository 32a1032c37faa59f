// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/contour.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::fabrication {
namespace {

using geometry::Box;
using geometry::Point2;

/// Call visit(point, place of the next one) for every point.
template <class Visit>
void each_segment(const Contour& contour, const Visit& visit) {
    for (std::size_t i = 0; i < contour.size(); ++i)
        visit(contour[i], contour[(i + 1) % contour.size()].place);
}

/// Grow a box to hold the extreme points inside an arc. The caller adds the arc's ends.
void include_arc(Box& box, const ContourPoint& from, const Point2& to) {
    const Arc arc = arc_between(from, to);
    const double start = std::atan2(from.place.y - arc.center.y, from.place.x - arc.center.x);
    constexpr double kQuarter = std::numbers::pi / 2.0;
    const double low = std::min(start, start + arc.sweep);
    const double high = std::max(start, start + arc.sweep);
    for (double angle = std::ceil(low / kQuarter) * kQuarter; angle <= high; angle += kQuarter)
        box = geometry::united(box, arc.center + arc.radius * geometry::direction(angle));
}

}  // namespace

Arc arc_between(const ContourPoint& from, const Point2& to) {
    const double b = from.bulge;
    const double chord = distance(from.place, to);
    const double to_center = (1.0 - b * b) / (4.0 * b);  // from the chord's middle to the left, in chords
    return {.center = {0.5 * (from.place.x + to.x) - to_center * (to.y - from.place.y),
                       0.5 * (from.place.y + to.y) + to_center * (to.x - from.place.x)},
            .radius = chord * (1.0 + b * b) / (4.0 * std::abs(b)),
            .sweep = 4.0 * std::atan(b)};
}

double signed_area(const Contour& contour) {
    double area = 0.0;
    if (contour.empty()) return area;
    const Point2 origin = contour.front().place;
    each_segment(contour, [&](const ContourPoint& from, const Point2& to) {
        area += 0.5 * ((from.place.x - origin.x) * (to.y - origin.y) -
                       (to.x - origin.x) * (from.place.y - origin.y));
        if (from.bulge == 0.0) return;
        const Arc arc = arc_between(from, to);
        area += 0.5 * arc.radius * arc.radius * (arc.sweep - std::sin(arc.sweep));
    });
    return area;
}

double length(const Contour& contour) {
    double sum = 0.0;
    each_segment(contour, [&](const ContourPoint& from, const Point2& to) {
        if (from.bulge == 0.0) {
            sum += distance(from.place, to);
        } else {
            const Arc arc = arc_between(from, to);
            sum += arc.radius * std::abs(arc.sweep);
        }
    });
    return sum;
}

geometry::Polygon flattened(const Contour& contour, double tolerance) {
    geometry::Polygon polygon;
    each_segment(contour, [&](const ContourPoint& from, const Point2& to) {
        polygon.push_back(from.place);
        if (from.bulge == 0.0) return;
        const Arc arc = arc_between(from, to);
        const double step = 2.0 * std::acos(std::clamp(1.0 - tolerance / arc.radius, 0.0, 1.0));
        const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / step)));
        const double start = std::atan2(from.place.y - arc.center.y, from.place.x - arc.center.x);
        for (int i = 1; i < chords; ++i) {
            const double angle = start + arc.sweep * i / chords;
            polygon.push_back(
                {arc.center.x + arc.radius * std::cos(angle), arc.center.y + arc.radius * std::sin(angle)});
        }
    });
    return polygon;
}

Contour circle(const Point2& center, double radius) {
    return {{{center.x - radius, center.y}, 1.0}, {{center.x + radius, center.y}, 1.0}};
}

Contour reversed(const Contour& contour) {
    Contour other;
    for (std::size_t i = contour.size(); i-- > 0;)
        other.push_back({contour[(i + 1) % contour.size()].place, -contour[i].bulge});
    return other;
}

Contour straight(const geometry::Polygon& polygon) {
    Contour contour;
    for (const Point2& point : polygon) contour.push_back({point, 0.0});
    return contour;
}

Box box_of(const Contour& contour) {
    const Point2& first = contour.front().place;
    Box box{first.x, first.y, first.x, first.y};
    each_segment(contour, [&](const ContourPoint& from, const Point2& to) {
        box = geometry::united(box, from.place);
        if (from.bulge != 0.0) include_arc(box, from, to);
    });
    return box;
}

}  // namespace fretwork::fabrication
