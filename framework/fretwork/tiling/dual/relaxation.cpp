// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/remeshing/inside.hpp>
#include <fretwork/tiling/remeshing/sites.hpp>
#include <fretwork/tiling/remeshing/triangulation.hpp>

#include <optional>
#include <span>
#include <vector>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// The centroid of a tile, whose parts are weighted with the wanted density of tiles.
/// @param sides  wanted sides at the polygon's vertices
Point2 weighted_centroid(const Polygon& polygon, std::span<const double> sides) {
    const Point2 middle = geometry::centroid(polygon);
    Point2 sum{};
    double weights = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t next = (i + 1) % polygon.size();
        const double side = (sides[i] + sides[next]) / (sides[0] + sides[1]);
        // Centroids with a density of h^-4 give tiles of size h.
        const double weight =
            cross(polygon[i] - middle, polygon[next] - middle) / (side * side * side * side);
        sum = sum + (weight / 3) * (polygon[i] + polygon[next] + middle);
        weights += weight;
    }
    return weights > 0 ? (1 / weights) * sum : middle;
}

/// The new places of sites, the centroids of a dual's tiles.
class Centroids {
  public:
    Centroids(const Dual& dual, const SizeField& field, const SharedTask& task) : dual_(dual) {
        if (field.is_uniform()) return;
        for (const DualVertex& vertex : dual.vertices) {
            task.check();
            wanted_.push_back(field.at(vertex.place));
        }
    }

    /// The centroid of a site's tile; nothing if the tile is turned over or has no area.
    std::optional<Point2> of(std::size_t site) {
        const Polygon polygon = polygon_of(dual_, site);
        if (polygon.size() < 3 || !(geometry::signed_area(polygon) > 0)) return std::nullopt;
        if (wanted_.empty()) return geometry::centroid(polygon);
        sides_.clear();
        for (const DualVertexIndex v : dual_.cells[site]) sides_.push_back(wanted_[v]);
        return weighted_centroid(polygon, sides_);
    }

  private:
    const Dual& dual_;
    // Wanted sides at the vertices; empty: the same side everywhere.
    base::IndexVector<DualVertexIndex, double> wanted_;
    std::vector<double> sides_;
};

}  // namespace

std::vector<Point2> relax(const Rim& rim, const SizeField& field, std::vector<Point2> sites, int iterations,
                          SharedTask& task) {
    const InsideTest is_inside(rim, 0.0, task.control());
    for (int i = 0; i < iterations; ++i) {
        task.advance();
        if (sites.empty()) continue;
        Triangulation triangulation = triangulate(rim, sites, task);
        flip_ears(triangulation, task);
        const Dual dual = dual_of(rim, triangulation, task);
        Centroids centroids(dual, field, task);
        for (std::size_t site = 0; site < sites.size(); ++site) {
            task.check();
            const auto target = centroids.of(site);
            if (target && is_inside(*target, 0.0)) sites[site] = *target;
        }
    }
    return sites;
}

}  // namespace fretwork::tiling::detail
