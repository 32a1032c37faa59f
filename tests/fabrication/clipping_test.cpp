// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/fabrication/detail/clipping.hpp>
#include <fretwork/geometry/polygon.hpp>

namespace fretwork::fabrication {
namespace THIS_TEST {

using geometry::Polygon;

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

Polygon square(double side) {
    return {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}};
}

TEST(Clipping, ReachesAsFarAsItsGrid) {
    constexpr double kLarge = 7.9e9;  // m
    const std::vector<Polygon> large = {square(kLarge)};
    for (const auto& found : {detail::united(large), detail::difference(large.front(), {})}) {
        ASSERT_EQ(found.size(), 1U);
        EXPECT_NEAR(geometry::signed_area(found.front()) / (kLarge * kLarge), 1.0, 1e-12);
    }
}

TEST(Clipping, OfOutlinesBeyondItsGridIsRefused) {
    const std::vector<Polygon> small = {square(1.0)};
    const std::vector<Polygon> wide = {square(8.1e9)};
    const auto is_refused =
        HasSubstr("outlines are 8.1e+09 m wide, where at most 8e+09 m can be cut or printed");
    EXPECT_THAT(complaint_of([&] { (void)detail::united(wide); }), is_refused);
    EXPECT_THAT(complaint_of([&] { (void)detail::difference(wide.front(), small); }), is_refused);
    EXPECT_THAT(complaint_of([&] { (void)detail::merged(small, wide); }), is_refused);
    EXPECT_THAT(complaint_of([&] { (void)detail::without(wide, small); }), is_refused);
}

TEST(Clipping, ASurfaceBeyondTheGridIsNotMade) {
    EXPECT_THAT(complaint_of([] { (void)make_shape(star(3, 1e10), {}); }),
                AllOf(HasSubstr("outlines are 1.69e+10 m wide"), HasSubstr("at most 8e+09 m can be cut")));
}

}  // namespace THIS_TEST
}  // namespace fretwork::fabrication
