// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/fan.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/simulation/detail/condensed_pattern.hpp>
#include <fretwork/simulation/detail/own_axes.hpp>

namespace fretwork::simulation::detail {

TilePolygon tile_polygon_of(const Surface& surface, tiling::TileIndex tile, double grid) {
    geometry::Polygon polygon = tiling::tile_polygon(surface.tessellation, tile);
    const auto axes = shared_axes(polygon, grid);
    if (!axes) return {std::move(polygon), std::to_string(tile.value)};
    std::string key(reinterpret_cast<const char*>(axes->steps.data()),
                    axes->steps.size() * sizeof(std::int64_t));
    return {axes->polygon, std::move(key)};
}

CondensedPattern condensed_pattern(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                   const geometry::Polygon& polygon, const reduction::Setting& setting) {
    const pattern::Fan fan = pattern::make_fan(layout, pattern, static_cast<int>(polygon.size()));
    const mechanics::Frame frame = reduction::fan_frame(layout, fan, polygon, setting);
    CondensedPattern result{reduction::condensed_frame(frame, fan.interface_node_count)};
    const double mass_per_length = setting.material.density * setting.section.area;
    for (const auto& edge : fan.edges) {
        const Eigen::Vector3d along = frame.nodes[mechanics::NodeIndex(edge[1].value)] -
                                      frame.nodes[mechanics::NodeIndex(edge[0].value)];
        result.mass += mass_per_length * along.norm();
    }
    for (int i = 0; i < fan.interface_node_count; ++i)
        result.interface_nodes.push_back(frame.nodes[mechanics::NodeIndex(i)]);
    return result;
}

}  // namespace fretwork::simulation::detail
