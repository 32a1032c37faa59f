// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/reduction/condensed_tile.hpp>
#include <fretwork/simulation/model_catalogue.hpp>

namespace fretwork::simulation {
namespace {

std::unique_ptr<const mechanics::Element> condensed_element(const Surface& surface, tiling::TileIndex index) {
    const tiling::Tile& tile = surface.tessellation.tiles[static_cast<std::size_t>(index)];
    std::vector<mechanics::NodeIndex> nodes;
    for (const auto node : tile.interface_nodes) nodes.emplace_back(node.value);
    const pattern::Pattern& pattern = surface.patterns[static_cast<std::size_t>(tile.pattern)];
    return mechanics::linear_element(
        std::move(nodes),
        reduction::condensed_tile(surface.layout, pattern, tiling::tile_polygon(surface.tessellation, index),
                                  {surface.setting.section, surface.setting.material}));
}

}  // namespace

mechanics::Assembly build_condensed_model(const Surface& surface, const Conditions& conditions) {
    mechanics::Assembly assembly;
    for (const pattern::Point2& node : surface.tessellation.interface_nodes)
        assembly.nodes.emplace_back(node.x, node.y, 0.0);
    assembly.reported_nodes = static_cast<int>(assembly.nodes.size());
    assembly.elements.resize(surface.tessellation.tiles.size());
    base::parallel_for(assembly.elements.size(), 0, [&](std::size_t tile) {
        assembly.elements[tile] = condensed_element(surface, tiling::TileIndex(tile));
    });
    assembly.supports = conditions.supports;
    assembly.prescribed = conditions.prescribed;
    assembly.loads = mechanics::NodeValues::Zero(assembly.reported_nodes, mechanics::kDofsPerNode);
    for (const mechanics::NodalLoad& load : conditions.loads) {
        assembly.loads.row(load.node).head<3>() += load.force;
        assembly.loads.row(load.node).tail<3>() += load.moment;
    }
    return assembly;
}

}  // namespace fretwork::simulation
