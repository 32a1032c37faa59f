// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/detail/own_axes.hpp>

#include <cmath>

namespace fretwork::simulation::detail {

double congruence_grid(const tiling::Tessellation& tessellation) {
    constexpr double kShare = 1e-9;
    return std::exp2(std::floor(std::log2(kShare * tiling::mean_tile_side(tessellation))));
}

OwnAxes own_axes(const geometry::Polygon& polygon, double grid) {
    const geometry::Point2 center = geometry::centroid(polygon);
    const Eigen::Vector2d side(polygon[1].x - polygon[0].x, polygon[1].y - polygon[0].y);
    const Eigen::Vector2d along = side.normalized();
    OwnAxes axes;
    axes.turn << along.x(), -along.y(), 0.0, along.y(), along.x(), 0.0, 0.0, 0.0, 1.0;
    axes.origin = {center.x, center.y, 0.0};
    for (const geometry::Point2& vertex : polygon) {
        const double dx = vertex.x - center.x;
        const double dy = vertex.y - center.y;
        const double x = std::round((along.x() * dx + along.y() * dy) / grid);
        const double y = std::round((along.x() * dy - along.y() * dx) / grid);
        axes.polygon.push_back({x * grid, y * grid});
        axes.steps.insert(axes.steps.end(), {static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)});
    }
    return axes;
}

std::optional<OwnAxes> shared_axes(const geometry::Polygon& polygon, double grid) {
    OwnAxes axes = own_axes(polygon, grid);
    if (!geometry::is_convex(axes.polygon)) return std::nullopt;
    return axes;
}

}  // namespace fretwork::simulation::detail
