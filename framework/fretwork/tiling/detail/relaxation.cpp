// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/dual.hpp>
#include <fretwork/tiling/detail/ears.hpp>
#include <fretwork/tiling/detail/inside.hpp>
#include <fretwork/tiling/detail/plane.hpp>
#include <fretwork/tiling/detail/sites.hpp>
#include <fretwork/tiling/detail/triangulation.hpp>

#include <span>

namespace fretwork::tiling::detail {
namespace {

/// The centroid of a tile, its parts weighted with the number of tiles that are wanted there.
/// @param sides  wanted at the polygon's vertices
Point2 weighted_centroid(const Polygon& polygon, std::span<const double> sides) {
    const Point2 middle = pattern::centroid(polygon);
    Point2 sum{};
    double weights = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t next = (i + 1) % polygon.size();
        const double side = (sides[i] + sides[next]) / (sides[0] + sides[1]);
        // Tiles of size h come about where the density of the centroid is h^-4.
        const double weight =
            cross(polygon[i] - middle, polygon[next] - middle) / (side * side * side * side);
        sum = sum + (weight / 3) * (polygon[i] + polygon[next] + middle);
        weights += weight;
    }
    return weights > 0 ? (1 / weights) * sum : middle;
}

}  // namespace

std::vector<Point2> relax(const Rim& rim, const SizeField& field, std::vector<Point2> sites, int iterations,
                          Work& work) {
    const InsideTest is_inside(rim, 0.0);
    std::vector<double> wanted;
    std::vector<double> sides;
    for (int i = 0; i < iterations; ++i) {
        work.advance();
        if (sites.empty()) continue;
        Triangulation triangulation = triangulate(rim, sites, work);
        flip_ears(triangulation);
        const Dual dual = dual_of(rim, triangulation, work);
        wanted.clear();
        if (!field.is_uniform()) {
            for (const DualVertex& vertex : dual.vertices) wanted.push_back(field.at(vertex.place));
        }
        for (std::size_t site = 0; site < sites.size(); ++site) {
            work.check();
            const Polygon polygon = polygon_of(dual, site);
            if (polygon.size() < 3 || !(pattern::signed_area(polygon) > 0)) continue;
            sides.clear();
            if (!field.is_uniform()) {
                for (const int v : dual.cells[site]) sides.push_back(wanted[static_cast<std::size_t>(v)]);
            }
            const Point2 target =
                field.is_uniform() ? pattern::centroid(polygon) : weighted_centroid(polygon, sides);
            if (is_inside(target, 0.0)) sites[site] = target;
        }
    }
    return sites;
}

}  // namespace fretwork::tiling::detail
