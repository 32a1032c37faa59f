// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/tiling/detail/message_text.hpp>
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

Rim even_rim(const Outline& outline, double spacing, const base::Control& control) {
    Rim rim;
    rim.curves.emplace_back(outline.boundary);
    for (const Polygon& hole : outline.holes) rim.curves.emplace_back(hole);
    for (std::size_t loop = 0; loop < rim.curves.size(); ++loop) {
        control.check();
        const auto first = static_cast<int>(rim.points.size());
        for (const Place& place : sample_places(rim.curves[loop], spacing)) {
            rim.points.push_back({rim.curves[loop].at(place.along), static_cast<int>(loop), place.is_corner});
            rim.next.push_back(static_cast<int>(rim.points.size()));
        }
        rim.next.back() = first;
    }
    return rim;
}

std::optional<std::string> flaw_of(const Rim& rim, const base::Control& control) {
    std::vector<Polygon> loops(rim.curves.size());
    for (const RimPoint& point : rim.points)
        loops[static_cast<std::size_t>(point.loop)].push_back(point.place);
    return outline_flaw(loops, control);
}

}  // namespace

Rim sample_rim(const Outline& outline, double spacing, const base::Control& control) {
    std::optional<std::string> flaw;
    for (double finer = spacing; finer > kFinest * spacing; finer /= 2) {
        Rim rim = even_rim(outline, finer, control);
        flaw = flaw_of(rim, control);
        if (!flaw) return rim;
    }
    throw base::GeometryError("the outline is far too narrow somewhere for tiles " + metres(spacing) +
                              " wide; choose a smaller edge length (" + *flaw + ")");
}

}  // namespace fretwork::tiling::detail
