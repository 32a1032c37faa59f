// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/tiling/detail/gaps.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::tiling::detail {
namespace {

using testing::ElementsAre;

/// Two tiles below a triangular hole (loop 1), on whose lowest vertex, 0, they meet, and the outline (loop 0)
/// on which they end at vertices 1 and 2; and a third tile above the hole that holds them together.
Dual tiles_around_a_hole(pattern::Point2 left_end, pattern::Point2 right_end) {
    Dual dual;
    dual.vertices = {{{0, 0}, 1, true},     {left_end, 0}, {right_end, 0},
                     {{-2, -1}, 0},         {{8, -1}, 0},  {{-0.5, 0.5}, 1, true},
                     {{0.5, 0.5}, 1, true}, {{-2, 1}, 0},  {{8, 1}, 0}};
    dual.cells = {{3, 1, 0, 5, 7}, {2, 4, 8, 6, 0}, {5, 6, 8, 7}};
    return dual;
}

TEST(Gaps, AWedgeIsClosedInItsMiddle) {
    Dual dual = tiles_around_a_hole({-0.2, -1}, {0.3, -1});
    ASSERT_EQ(count_pinches(dual, {}), 1);
    close_gaps(dual, {});
    EXPECT_EQ(count_pinches(dual, {}), 0);
    EXPECT_THAT(dual.cells[0], ElementsAre(3, 1, 0, 5, 7));
    EXPECT_THAT(dual.cells[1], ElementsAre(1, 4, 8, 6, 0));
    EXPECT_DOUBLE_EQ(dual.vertices[1].place.x, 0.05);
}

TEST(Gaps, ACornerOfTheOutlineStaysWhereItIs) {
    Dual dual = tiles_around_a_hole({-0.2, -1}, {0.3, -1});
    dual.vertices[2].is_fixed = true;
    close_gaps(dual, {});
    EXPECT_EQ(count_pinches(dual, {}), 0);
    EXPECT_THAT(dual.cells[0], ElementsAre(3, 2, 0, 5, 7));
    EXPECT_EQ(dual.vertices[2].place.x, 0.3);
}

TEST(Gaps, AWedgeStaysOpenWhereATileWouldNotBeConvex) {
    Dual dual = tiles_around_a_hole({-0.2, -1}, {6.2, -1});
    const auto cells = dual.cells;
    close_gaps(dual, {});
    EXPECT_EQ(dual.cells, cells);
    EXPECT_EQ(count_pinches(dual, {}), 1);
}

}  // namespace
}  // namespace fretwork::tiling::detail
