// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/frame/section.hpp>
#include <fretwork/simulation/detail/tile_builder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::simulation::detail {
namespace THIS_TEST {

/// A surface of one hexagon, larger than the paper's.
Surface one_tile(double scale) {
    Surface surface = make_surface(test::honeycomb(1, 1, {"0-1+1-6"}), nullptr);
    for (geometry::Point2& vertex : surface.tessellation.vertices)
        vertex = {scale * vertex.x, scale * vertex.y};
    return surface;
}

TEST(TileBuilder, KeepsFewOfTheTilesThatNobodyUses) {
    TileBuilder builder;
    const ModelChoice condensed{"condensed"};
    const auto used = builder.build_all(one_tile(1.0), condensed, {.threads = 1});
    std::size_t most = 0;
    for (std::size_t i = 1; i <= 2 * TileBuilder::kMostUnused; ++i) {
        (void)builder.build_all(one_tile(1.0 + 0.0004 * static_cast<double>(i)), condensed, {.threads = 1});
        most = std::max(most, builder.kept_count());
    }
    EXPECT_EQ(builder.built_count(), 2 * TileBuilder::kMostUnused + 1);
    EXPECT_GE(most, TileBuilder::kMostUnused);
    EXPECT_LE(most, TileBuilder::kMostUnused + 2) << "with that in use, and the last one built";
    const auto again = builder.build_all(one_tile(1.0), condensed, {.threads = 1});
    EXPECT_EQ(again[0].structure, used[0].structure) << "what is used is kept";
}

/// By rounding, the stiffness of bars of a ten thousandth of a millimetre resists rigid motions.
TEST(TileBuilder, NamesTheTileWhoseBarsAreTooThinToBeCondensed) {
    Surface surface = one_tile(1.0);
    surface.setting.section = mechanics::rectangle_section(1e-7, 1e-7);
    for (const char* model : {"condensed", "corotational"}) {
        TileBuilder builder;
        try {
            (void)builder.build_all(surface, {model}, {.threads = 1});
            ADD_FAILURE() << model << " takes any bars";
        } catch (const base::NumericalError& error) {
            EXPECT_THAT(error.what(),
                        testing::AllOf(testing::StartsWith("tile 0, pattern 0-1+1-6: the bars are too thin"),
                                       testing::HasSubstr("of its length thick")))
                << model;
        }
    }
    surface.setting.section = mechanics::rectangle_section(2e-6, 2e-6);
    EXPECT_NO_THROW((void)TileBuilder().build_all(surface, {"corotational"}, {.threads = 1}));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation::detail
