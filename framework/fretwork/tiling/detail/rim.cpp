// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/detail/outline_check.hpp>
#include <fretwork/tiling/detail/plane.hpp>
#include <fretwork/tiling/detail/rim.hpp>

#include <algorithm>
#include <numbers>
#include <optional>

namespace fretwork::tiling::detail {
namespace {

constexpr double kCornerReach = 0.25;  // of the spacing
constexpr double kCornerTurn =
    40.0 * std::numbers::pi / 180;  // a pentagon's corner is one, an octagon's just so

constexpr double kFinest = 0.1;  // of the spacing

struct Place {
    double along;
    bool is_corner;
};

/// Even places from one corner to the next, the first included; at least `fewest` of them.
void fill(double from, double to, double spacing, int fewest, std::vector<Place>& places) {
    const int count = std::max(fewest, static_cast<int>(std::lround((to - from) / spacing)));
    for (int i = 0; i < count; ++i) places.push_back({from + (to - from) * i / count, false});
}

std::vector<Place> sample_places(const ClosedCurve& curve, double spacing) {
    std::vector<double> corners = curve.corners(kCornerReach * spacing, kCornerTurn);
    std::vector<Place> places;
    if (corners.empty()) fill(0, curve.length(), spacing, 3, places);
    const int fewest = corners.size() == 1 ? 3 : corners.size() == 2 ? 2 : 1;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t first = places.size();
        const double to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + curve.length();
        fill(corners[i], to, spacing, fewest, places);
        places[first].is_corner = true;
    }
    return places;
}

Rim even_rim(const Outline& outline, double spacing) {
    Rim rim;
    rim.curves.emplace_back(outline.boundary);
    for (const Polygon& hole : outline.holes) rim.curves.emplace_back(hole);
    for (std::size_t loop = 0; loop < rim.curves.size(); ++loop) {
        const auto first = static_cast<int>(rim.points.size());
        for (const Place& place : sample_places(rim.curves[loop], spacing)) {
            rim.points.push_back({rim.curves[loop].at(place.along), static_cast<int>(loop), place.is_corner});
            rim.next.push_back(static_cast<int>(rim.points.size()));
        }
        rim.next.back() = first;
    }
    return rim;
}

std::optional<std::string> flaw_of(const Rim& rim) {
    std::vector<Polygon> loops(rim.curves.size());
    for (const RimPoint& point : rim.points)
        loops[static_cast<std::size_t>(point.loop)].push_back(point.place);
    return outline_flaw(loops);
}

}  // namespace

Rim sample_rim(const Outline& outline, double spacing) {
    std::optional<std::string> flaw;
    for (double finer = spacing; finer > kFinest * spacing; finer /= 2) {
        Rim rim = even_rim(outline, finer);
        flaw = flaw_of(rim);
        if (!flaw) return rim;
    }
    throw base::GeometryError("the outline is far too narrow somewhere for tiles " +
                              base::format_number(std::round(spacing * 1e5) / 1e5) +
                              " m wide; choose a smaller edge length (" + *flaw + ")");
}

bool is_inside(const Rim& rim, Point2 point, double margin) {
    bool inside = false;
    for (std::size_t i = 0; i < rim.points.size(); ++i) {
        const Point2 a = rim.points[i].place;
        const Point2 b = rim.points[static_cast<std::size_t>(rim.next[i])].place;
        if (margin > 0 && distance(nearest_on_side(a, b, point), point) < margin) return false;
        const bool is_beside = (a.y > point.y) != (b.y > point.y);
        if (is_beside && (cross(b - a, point - a) > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside;
}

}  // namespace fretwork::tiling::detail
