// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/geometry/box_grid.hpp>
#include <fretwork/geometry/point_grid.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

namespace fretwork::geometry {
namespace THIS_TEST {

Point2 random_point(base::SplitMix64& random) {
    return {4.0 * random.share() - 2.0, 4.0 * random.share() - 2.0};
}

TEST(PointGrid, FindsWhatALookAtEveryPointFinds) {
    base::SplitMix64 random(1);
    PointGrid grid(0.1);
    int near = 0;
    for (int round = 0; round < 2000; ++round) {
        const Point2 place = random_point(random);
        const double reach = 0.1 * random.share();
        const bool expected =
            std::ranges::any_of(grid.points(), [&](Point2 point) { return distance(point, place) < reach; });
        ASSERT_EQ(grid.has_near(place, reach), expected) << "round " << round;
        near += expected ? 1 : 0;
        grid.add(place);
    }
    EXPECT_GT(near, 100);
    EXPECT_LT(near, 1900);
}

TEST(PointGrid, NumbersPointsAsTheyCome) {
    PointGrid grid(1.0);
    EXPECT_EQ(grid.add({0.5, 0.5}), 0U);
    EXPECT_EQ(grid.add({-0.5, 0.5}), 1U);
    std::vector<std::size_t> seen;
    grid.visit_around({0.1, 0.1}, [&](std::size_t number) { seen.push_back(number); });
    EXPECT_THAT(seen, testing::UnorderedElementsAre(0U, 1U));
}

TEST(PointGrid, GivesNearPointsTheSmallestNumberAmongThem) {
    PointGrid grid(1.0);
    EXPECT_EQ(grid.number_of({0.0, 0.0}, 0.5), 0U);
    EXPECT_EQ(grid.number_of({0.75, 0.0}, 0.5), 1U);
    EXPECT_EQ(grid.number_of({0.45, 0.0}, 0.5), 0U) << "both are within reach, and the second is nearer";
    EXPECT_EQ(grid.number_of({1.25, 0.0}, 0.5), 1U) << "the reach itself counts";
    EXPECT_EQ(grid.number_of({1.26, 0.0}, 0.5), 2U);
    EXPECT_EQ(grid.points().size(), 3U);
}

TEST(PointGrid, TakesPlacesThatAreFarAway) {
    PointGrid grid(1e-5);
    for (const double away : {1.1e10, 1e30, -1e300}) {
        EXPECT_FALSE(grid.has_near({away, -away}, 1e-5)) << away;
        grid.add({away, -away});
        EXPECT_TRUE(grid.has_near({away, -away}, 1e-5)) << away;
    }
}

TEST(BoxGrid, FindsWhatALookAtEveryBoxFinds) {
    base::SplitMix64 random(2);
    const auto random_box = [&] {
        const Point2 corner = random_point(random);
        return Box{corner.x, corner.y, corner.x + 0.3 * random.share(), corner.y + 0.3 * random.share()};
    };
    std::vector<Box> boxes(300);
    std::ranges::generate(boxes, random_box);
    const BoxGrid grid(boxes);
    for (int round = 0; round < 200; ++round) {
        const Box box = random_box();
        std::vector<std::size_t> expected;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (boxes[i].meets(box)) expected.push_back(i);
        ASSERT_EQ(grid.meeting(box), expected) << "round " << round;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::geometry
