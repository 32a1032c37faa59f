// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/geometry/point_grid.hpp>
#include <fretwork/tiling/remeshing/inside.hpp>
#include <fretwork/tiling/remeshing/sites.hpp>
#include <fretwork/tiling/remeshing/triangulation.hpp>

#include <algorithm>
#include <tuple>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;

// The lengths are shares of the spacing.
// Smallest radius of a circle without sites that is filled; the radius is 0.58 in a regular lattice.
constexpr double kEmptyRadius = 0.8;
constexpr double kHalfBand = 0.45;       // the same radius between points of the rim
constexpr double kRimDistance = 0.35;    // smallest distance of a filling site from the rim
constexpr double kLeastFilling = 0.65;   // smallest distance of a filling site from other sites
constexpr double kBridgeDistance = 0.3;  // smallest distance of a bridging site from other sites
constexpr int kRounds = 8;

/// The triangle's circumcenter and radius.
struct EmptyCircle {
    double radius;
    Point2 middle;
};

std::vector<EmptyCircle> large_empty_circles(const Triangulation& triangulation, const Spacing& spacing,
                                             const SharedTask& task) {
    std::vector<EmptyCircle> circles;
    for (const auto& [a, b, c] : triangulation.triangles) {
        task.check();
        const auto place = [&](PointIndex point) { return triangulation.points[point]; };
        if (cross(place(b) - place(a), place(c) - place(a)) <= 0) continue;
        const Point2 middle = circumcenter(place(a), place(b), place(c));
        const double radius = distance(middle, place(a));
        const bool is_on_rim = triangulation.is_rim(a) && triangulation.is_rim(b) && triangulation.is_rim(c);
        const double least = (is_on_rim ? kHalfBand : kEmptyRadius) * spacing.at(middle);
        if (radius > least) circles.push_back({radius, middle});
    }
    const auto key = [](const EmptyCircle& circle) {
        return std::tuple(-circle.radius, circle.middle.x, circle.middle.y);
    };
    std::ranges::sort(circles, {}, key);
    return circles;
}

geometry::PointGrid grid_of(const std::vector<Point2>& sites, const Spacing& spacing,
                            const SharedTask& task) {
    geometry::PointGrid grid(spacing.largest());
    for (const Point2& site : sites) {
        task.check();
        grid.add(site);
    }
    return grid;
}

}  // namespace

void fill_empty_parts(const Rim& rim, const Spacing& spacing, std::vector<Point2>& sites,
                      const SharedTask& task) {
    const InsideTest is_inside(rim, kRimDistance * spacing.largest(), task.control());
    geometry::PointGrid grid = grid_of(sites, spacing, task);
    for (int round = 0; round < kRounds; ++round) {
        const std::size_t before = sites.size();
        for (const EmptyCircle& circle : large_empty_circles(triangulate(rim, sites, task), spacing, task)) {
            task.check();
            const double wanted = spacing.at(circle.middle);
            if (!is_inside(circle.middle, kRimDistance * wanted)) continue;
            if (grid.has_near(circle.middle, kLeastFilling * wanted)) continue;
            grid.add(circle.middle);
            sites.push_back(circle.middle);
        }
        if (sites.size() == before) return;
    }
}

bool bridge_chords(const Rim& rim, const Spacing& spacing, std::vector<Point2>& sites,
                   const SharedTask& task) {
    Triangulation triangulation = triangulate(rim, sites, task);
    flip_ears(triangulation, task);
    geometry::PointGrid grid = grid_of(sites, spacing, task);
    const std::size_t before = sites.size();
    for (const Chord& chord : chords_of(triangulation)) {
        task.check();
        const auto place = [&](PointIndex point) { return triangulation.points[point]; };
        const Point2 middle = between(place(chord.from), place(chord.to), 0.5);
        if (grid.has_near(middle, kBridgeDistance * spacing.at(middle))) continue;
        grid.add(middle);
        sites.push_back(middle);
    }
    return sites.size() > before;
}

}  // namespace fretwork::tiling::detail
