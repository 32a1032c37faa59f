// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/detail/joined_tiles.hpp>

namespace fretwork::simulation::detail {
namespace {

using mechanics::NodeIndex;

/// The nodes of a tile in the surface: its interface nodes, then its inner ones.
std::vector<NodeIndex> nodes_of(const tiling::Tile& tile, std::size_t first_inner, std::size_t inner_count) {
    std::vector<NodeIndex> nodes;
    for (const tiling::InterfaceIndex node : tile.interface_nodes) nodes.emplace_back(node.value);
    for (std::size_t i = 0; i < inner_count; ++i) nodes.emplace_back(first_inner + i);
    return nodes;
}

TileStart end_of(const reduction::StructureParts& parts) {
    return {parts.beams.nodes.size(), parts.beams.beams.size(), parts.elements.size()};
}

}  // namespace

std::vector<mechanics::Result::Node> result_nodes(const Surface& surface,
                                                  const mechanics::Assembly& assembly) {
    std::vector<mechanics::Result::Node> nodes;
    const auto interface_count = static_cast<int>(surface.tessellation.interface_nodes.size());
    for (int i = 0; i < assembly.reported_nodes; ++i)
        nodes.push_back({i, assembly.nodes[i], i < interface_count});
    return nodes;
}

std::size_t first_element(const mechanics::Assembly& assembly, std::span<const TileStart> starts,
                          tiling::TileIndex tile) {
    return assembly.elements.size() - starts.back().element + starts[tile].element;
}

mechanics::NodeValues rows_of_tile(const mechanics::NodeValues& rows,
                                   std::span<const tiling::InterfaceIndex> interface_nodes,
                                   const InnerNodes& inner) {
    const auto inner_count = static_cast<Eigen::Index>(inner.end - inner.first);
    mechanics::NodeValues own(std::ssize(interface_nodes) + inner_count, mechanics::kDofsPerNode);
    Eigen::Index next = 0;
    for (const tiling::InterfaceIndex node : interface_nodes) own.row(next++) = rows.row(node.value);
    own.bottomRows(inner_count) = rows.middleRows(static_cast<Eigen::Index>(inner.first), inner_count);
    return own;
}

JoinedTiles join_tiles(const Surface& surface, std::span<const BuiltTile> tiles,
                       const base::Control& control) {
    JoinedTiles joined;
    std::vector<Eigen::Vector3d>& nodes = joined.parts.beams.nodes;
    for (const geometry::Point2& node : surface.tessellation.interface_nodes)
        nodes.emplace_back(node.x, node.y, 0.0);
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        control.check();
        joined.starts.push_back(end_of(joined.parts));
        const BuiltTile& built = tiles[t];
        const auto inner = built.structure->inner_nodes();
        const auto own =
            nodes_of(surface.tessellation.tiles[t], joined.starts.back().inner_node, inner.size());
        for (const Eigen::Vector3d& node : inner) nodes.push_back(built.origin + built.turn * node);
        built.structure->add_to(joined.parts, {built.turn, own});
    }
    joined.starts.push_back(end_of(joined.parts));
    return joined;
}

std::optional<mechanics::Elements> replacement(std::span<const TileStart> starts, const Surface& surface,
                                               tiling::TileIndex tile, const BuiltTile& built) {
    const std::size_t t = tile;
    const TileStart& start = starts[t];
    const TileStart& end = starts[t + 1];
    const bool had_only_elements = start.inner_node == end.inner_node && start.beam == end.beam;
    if (!had_only_elements || !built.structure->inner_nodes().empty()) return std::nullopt;
    reduction::StructureParts parts;
    const auto nodes = nodes_of(surface.tessellation.tiles[t], 0, 0);
    built.structure->add_to(parts, {built.turn, nodes});
    if (!parts.beams.beams.empty() || parts.elements.size() != end.element - start.element)
        return std::nullopt;
    return std::move(parts.elements);
}

}  // namespace fretwork::simulation::detail
