// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation.hpp>

namespace fretwork::tiling {
namespace THIS_TEST {

using test::complaint_of;
using testing::HasSubstr;

outlines::Outline square_at(double x, double side) {
    return outlines::make_outline({{x, 0}, {x + side, 0}, {x + side, side}, {x, side}}, {});
}
const pattern::NodeLayout kLayout = pattern::find_node_layout("paper7");
const TessellationOptions kOptions{.edge_length = 0.03};

TEST(TessellateParts, PartsFollowEachOtherAndShareNothing) {
    const TessellationResult first = tessellate(square_at(0, 0.3), kLayout, kOptions);
    const TessellationResult second = tessellate(square_at(1, 0.2), kLayout, kOptions);
    const TessellationResult both =
        tessellate_parts({square_at(0, 0.3), square_at(1, 0.2)}, kLayout, kOptions);
    EXPECT_NO_THROW(validate(both.tessellation, kLayout));
    ASSERT_EQ(both.tessellation.tiles.size(),
              first.tessellation.tiles.size() + second.tessellation.tiles.size());
    EXPECT_EQ(both.tessellation.interface_nodes.size(),
              first.tessellation.interface_nodes.size() + second.tessellation.interface_nodes.size());
    const auto number = static_cast<int>(first.tessellation.tiles.size());
    EXPECT_EQ(tile_polygon(both.tessellation, TileIndex(0)), tile_polygon(first.tessellation, TileIndex(0)));
    EXPECT_EQ(tile_polygon(both.tessellation, TileIndex(number)),
              tile_polygon(second.tessellation, TileIndex(0)));
}

TEST(TessellateParts, TheReportIsOfAllTiles) {
    const TessellationResult both =
        tessellate_parts({square_at(0, 0.3), square_at(1, 0.2)}, kLayout, kOptions);
    double area = 0;
    for (int tile = 0; tile < both.report.tiles; ++tile)
        area += geometry::signed_area(tile_polygon(both.tessellation, TileIndex(tile)));
    EXPECT_EQ(both.report.tiles, static_cast<int>(both.tessellation.tiles.size()));
    EXPECT_NEAR(both.report.covered_share, area / (0.09 + 0.04), 1e-9);
}

TEST(TessellateParts, APartWithoutInnerTilesLeavesTheShareOfInnerHexagons) {
    const outlines::Outline strip = outlines::make_outline({{1, 0}, {1.3, 0}, {1.3, 0.04}, {1, 0.04}}, {});
    const TessellationReport alone = tessellate(square_at(0, 0.3), kLayout, kOptions).report;
    const TessellationReport both = tessellate_parts({square_at(0, 0.3), strip}, kLayout, kOptions).report;
    ASSERT_EQ(tessellate(strip, kLayout, kOptions).report.inner_tiles, 0);
    EXPECT_EQ(both.inner_tiles, alone.inner_tiles);
    EXPECT_NEAR(both.inner_hexagon_share, alone.inner_hexagon_share, 1e-12);
}

TEST(TessellateParts, OnePartIsTiledAsByItself) {
    const TessellationResult alone = tessellate(square_at(0, 0.3), kLayout, kOptions);
    EXPECT_EQ(tessellate_parts({square_at(0, 0.3)}, kLayout, kOptions).tessellation.interface_nodes,
              alone.tessellation.interface_nodes);
}

TEST(TessellateParts, APartThatIsTooSmallIsNamed) {
    EXPECT_THAT(complaint_of([] {
                    TessellationOptions options = kOptions;
                    options.smallest_side = 0.002;  // of a bar
                    tessellate_parts({square_at(0, 0.3), square_at(1, 0.001)}, kLayout, options);
                }),
                HasSubstr("part 2 of 2: "));
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling
