// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/tiling/tessellation_fan.hpp>

#include <map>

namespace fretwork::tiling {
namespace {

class FanAssembler {
  public:
    FanAssembler(const pattern::NodeLayout& layout, const Tessellation& tessellation)
        : layout_(layout), tessellation_(tessellation) {
        result_.nodes = tessellation.interface_nodes;
        result_.interface_node_count = static_cast<int>(tessellation.interface_nodes.size());
    }

    TessellationFan run() {
        for (std::size_t t = 0; t < tessellation_.tiles.size(); ++t) add_tile(TileIndex(t));
        result_.first_edge.push_back(static_cast<int>(result_.edges.size()));
        return std::move(result_);
    }

  private:
    /// The fan of a tile, which depends only on the tile's pattern and its number of sides.
    const pattern::Fan& fan_of(TileIndex index) {
        const Tile& tile = tessellation_.tiles[index];
        const pattern::NamedPattern& pattern = painted_pattern_of(tessellation_, index);
        const auto sides = static_cast<int>(tile.vertices.size());
        const auto [entry, is_new] = fans_.try_emplace({tile.pattern, sides});
        if (is_new) entry->second = pattern::make_fan(layout_, pattern.pattern, sides);
        return entry->second;
    }

    void add_tile(TileIndex index) {
        const pattern::Fan& fan = fan_of(index);
        const Tile& tile = tessellation_.tiles[index];
        if (std::ssize(tile.interface_nodes) != fan.interface_node_count)
            throw base::InputError("tile " + std::to_string(index.value) + " has " +
                                   std::to_string(tile.interface_nodes.size()) +
                                   " interface nodes, where its layout " + layout_.name() + " has " +
                                   std::to_string(fan.interface_node_count));
        std::vector<TessellationNodeIndex> nodes;
        for (const InterfaceIndex node : tile.interface_nodes) nodes.emplace_back(node.value);
        const auto places = pattern::place_fan(layout_, fan, tile_polygon(tessellation_, index));
        for (std::size_t i = nodes.size(); i < places.size(); ++i) {
            nodes.emplace_back(result_.nodes.size());
            result_.nodes.push_back(places[i]);
        }
        result_.first_edge.push_back(static_cast<int>(result_.edges.size()));
        for (const auto& [a, b] : fan.edges) {
            result_.edges.push_back({{nodes[a], nodes[b]}, index});
        }
        result_.tile_nodes.push_back(std::move(nodes));
    }

    const pattern::NodeLayout& layout_;
    const Tessellation& tessellation_;
    std::map<std::pair<int, int>, pattern::Fan> fans_;  // fans by pattern and number of sides
    TessellationFan result_;
};

}  // namespace

TessellationFan assemble_fans(const pattern::NodeLayout& layout, const Tessellation& tessellation) {
    if (tessellation.layout != layout.name())
        throw base::InputError("the tessellation is for the node layout '" + tessellation.layout +
                               "', and not for '" + layout.name() + "'");
    return FanAssembler(layout, tessellation).run();
}

}  // namespace fretwork::tiling
