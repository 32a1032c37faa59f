// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation_fan.hpp>

namespace fretwork::tiling {
namespace THIS_TEST {

using geometry::Point2;
using test::complaint_of;
using testing::HasSubstr;

const std::vector<std::string> kPalette = {"0-1+1-6", "0-6+1-6", "1-5+5-6"};

pattern::NodeLayout paper_layout() {
    return pattern::find_node_layout("paper7");
}

Tessellation painted_rectangle() {
    TessellationOptions options;
    options.edge_length = 0.03;
    Tessellation tessellation =
        tessellate(outlines::make_outline({{0, 0}, {0.3, 0}, {0.3, 0.2}, {0, 0.2}}, {}), paper_layout(),
                   options)
            .tessellation;
    paint_randomly(tessellation, pattern::parse_named_patterns(paper_layout(), kPalette), 3);
    return tessellation;
}

TEST(TessellationFan, InterfaceNodesComeFirstWithTheirIds) {
    const Tessellation tessellation = painted_rectangle();
    const TessellationFan fan = assemble_fans(paper_layout(), tessellation);
    ASSERT_EQ(static_cast<std::size_t>(fan.interface_node_count), tessellation.interface_nodes.size());
    for (std::size_t i = 0; i < tessellation.interface_nodes.size(); ++i)
        EXPECT_EQ(fan.nodes[i], tessellation.interface_nodes[i]);
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        for (std::size_t i = 0; i < tessellation.tiles[t].interface_nodes.size(); ++i)
            EXPECT_EQ(fan.tile_nodes[t][i].value, tessellation.tiles[t].interface_nodes[i].value);
    }
}

TEST(TessellationFan, EveryTileHasTheFanOfItsPatternInItsPolygon) {
    const auto layout = paper_layout();
    const Tessellation tessellation = painted_rectangle();
    const TessellationFan all = assemble_fans(layout, tessellation);
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        const Tile& tile = tessellation.tiles[t];
        const auto pattern =
            pattern::parse_pattern_id(layout, kPalette[static_cast<std::size_t>(tile.pattern)]);
        const pattern::Fan fan = pattern::make_fan(layout, pattern, static_cast<int>(tile.vertices.size()));
        const auto places = pattern::place_fan(layout, fan, tile_polygon(tessellation, TileIndex(t)));
        ASSERT_EQ(all.tile_nodes[t].size(), places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Point2 there = all.nodes[all.tile_nodes[t][i]];
            EXPECT_NEAR(there.x, places[i].x, 1e-15);
            EXPECT_NEAR(there.y, places[i].y, 1e-15);
        }
        const auto first = static_cast<std::size_t>(all.first_edge[t]);
        ASSERT_EQ(static_cast<std::size_t>(all.first_edge[t + 1]) - first, fan.edges.size());
        for (std::size_t e = 0; e < fan.edges.size(); ++e) {
            EXPECT_EQ(all.edges[first + e].tile, TileIndex(t));
            for (std::size_t end = 0; end < 2; ++end)
                EXPECT_EQ(all.edges[first + e].nodes[end],
                          all.tile_nodes[t][static_cast<std::size_t>(fan.edges[e][end].value)]);
        }
    }
}

TEST(TessellationFan, InnerNodesBelongToOneTile) {
    const TessellationFan fan = assemble_fans(paper_layout(), painted_rectangle());
    std::vector<int> uses(fan.nodes.size());
    for (const auto& nodes : fan.tile_nodes) {
        for (const TessellationNodeIndex node : nodes) ++uses[static_cast<std::size_t>(node.value)];
    }
    for (std::size_t i = static_cast<std::size_t>(fan.interface_node_count); i < uses.size(); ++i)
        EXPECT_EQ(uses[i], 1);
}

TEST(TessellationFan, WhatDoesNotFitIsRefusedByName) {
    Tessellation tessellation = painted_rectangle();
    tessellation.tiles[4].pattern = -1;
    EXPECT_THAT(complaint_of([&] { assemble_fans(paper_layout(), tessellation); }),
                HasSubstr("tile 4 is not painted"));
    tessellation = painted_rectangle();
    tessellation.tiles[2].interface_nodes.pop_back();
    EXPECT_THAT(complaint_of([&] { assemble_fans(paper_layout(), tessellation); }), HasSubstr("tile 2"));
    tessellation.layout = "other";
    EXPECT_THAT(complaint_of([&] { assemble_fans(paper_layout(), tessellation); }), HasSubstr("'other'"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
