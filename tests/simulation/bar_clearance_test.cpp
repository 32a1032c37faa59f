// SPDX-License-Identifier: GPL-3.0-or-later
#include "honeycomb.hpp"
#include "stops.hpp"
#include "support.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/simulation/results/bar_clearance.hpp>

#include <limits>
#include <set>

namespace fretwork::simulation {
namespace THIS_TEST {

Surface surface_of(int columns, int rows) {
    return make_surface(test::honeycomb(columns, rows, {"0-1+1-5+1-6+5-6"}, 1), nullptr);
}

std::set<std::array<std::size_t, 2>> pairs_of(const std::vector<CloseBars>& close) {
    std::set<std::array<std::size_t, 2>> pairs;
    for (const CloseBars& pair : close) pairs.insert(pair.bars);
    return pairs;
}

/// The same tiles, of which some have no bars.
Surface without_tile(Surface surface, std::size_t tile) {
    surface.tessellation.tiles[tile].pattern = -1;
    return surface;
}

// A gap of a tile's size makes all bars of a tile close to each other, and far tiles are not close.
TEST(BarClearance, PairsAreFoundOnceAndOnlyWithinTheClearance) {
    const Surface surface = surface_of(3, 3);
    const auto near = close_bars(surface, 1e-3);
    const auto far = close_bars(surface, 1e-2);
    ASSERT_FALSE(near.empty());
    EXPECT_GT(far.size(), near.size());
    EXPECT_EQ(pairs_of(far).size(), far.size());
    std::set<std::array<std::size_t, 2>> narrowed;
    for (const CloseBars& pair : far) {
        EXPECT_LT(pair.bars[0], pair.bars[1]);
        EXPECT_LT(pair.gap, 1e-2);
        if (pair.gap < 1e-3) narrowed.insert(pair.bars);
    }
    EXPECT_EQ(pairs_of(near), narrowed) << "the pairs found within a smaller clearance";
}

TEST(BarClearance, BarsAreCloseWhateverLiesAroundThem) {
    const Surface surface = surface_of(2, 2);
    const auto without = close_bars(without_tile(surface, 3), 5e-3);
    std::size_t others = 0;
    for (const CloseBars& pair : close_bars(surface, 5e-3))
        others += pair.tiles[0].value != 3 && pair.tiles[1].value != 3 ? 1 : 0;
    EXPECT_EQ(without.size(), others);
}

TEST(BarClearance, AClearanceThatIsNoLengthIsRefused) {
    const Surface surface = surface_of(2, 2);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e-3}) {
        EXPECT_THAT(test::complaint_of([&] { (void)close_bars(surface, bad); }),
                    testing::AllOf(testing::HasSubstr("the clearance is " + base::format_number(bad)),
                                   testing::HasSubstr("0 m or more")));
    }
}

TEST(BarClearance, StopsAtAnyLookAndLooksAtEachBar) {
    const auto looks_at = [](const Surface& surface) {
        const test::StopAtLook never;
        (void)close_bars(surface, 0.0, never.control());
        return never.looks();
    };
    const Surface surface = surface_of(2, 2);
    test::expect_stops_at_any_look(
        [&](const base::Control& control) { (void)close_bars(surface, 0.0, control); }, [] {});
    EXPECT_GT(looks_at(surface_of(4, 4)), 3 * looks_at(surface));
}

}  // namespace THIS_TEST
}  // namespace fretwork::simulation
