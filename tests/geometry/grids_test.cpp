// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/geometry/box_grid.hpp>
#include <fretwork/geometry/point_grid.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
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

Box random_box(base::SplitMix64& random, double most) {
    const Point2 corner = random_point(random);
    return Box{corner.x, corner.y, corner.x + most * random.share(), corner.y + most * random.share()};
}

/// For boxes of at most a given size, and others.
void expect_meeting_boxes(const std::vector<Box>& others, double most) {
    base::SplitMix64 random(2);
    std::vector<Box> boxes = others;
    for (int i = 0; i < 300; ++i) boxes.push_back(random_box(random, most));
    const BoxGrid grid(boxes);
    for (int round = 0; round < 200; ++round) {
        const Box box = random_box(random, most);
        std::vector<std::size_t> expected;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (boxes[i].meets(box)) expected.push_back(i);
        ASSERT_EQ(grid.meeting(box), expected) << "round " << round;
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const std::vector<std::size_t> found = grid.meeting(boxes[i]);
        ASSERT_EQ(std::ranges::binary_search(found, i), boxes[i].meets(boxes[i])) << "box " << i;
    }
}

TEST(BoxGrid, FindsWhatALookAtEveryBoxFinds) {
    expect_meeting_boxes({}, 0.3);
    expect_meeting_boxes({}, 4.0);  // many cells each
}

TEST(BoxGrid, TakesBoxesOfAnySize) {
    constexpr double kMost = std::numeric_limits<double>::max();
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const auto square = [](double half) { return Box{-half, -half, half, half}; };
    expect_meeting_boxes({square(kMost), square(0.9 * kMost)}, 0.3);
    expect_meeting_boxes({square(1e200), Box{-1e200, 1, 1e200, 1}}, 0.3);
    expect_meeting_boxes({Box{-1, -1, kInfinite, 1}, square(kInfinite)}, 0.3);
    expect_meeting_boxes({Box{kInfinite, 0, kInfinite, 1}}, 0.3);
    expect_meeting_boxes({Box{kNone, -1, kNone, 1}}, 0.3);
    expect_meeting_boxes({square(1), Box{-1, kNone, 1, kNone}}, 0.3);
}

// In cells alone, these would take 30 GB.
TEST(BoxGrid, BoxesInOneAnotherTakeLittleMemory) {
    std::vector<Box> boxes;
    for (int i = 1; i <= 100'000; ++i) boxes.push_back(grown({0, 0, 0, 0}, i));
    const BoxGrid grid(boxes);
    EXPECT_THAT(grid.meeting({99'998.5, 0, 99'998.5, 0}), testing::ElementsAre(99'998U, 99'999U));
}

}  // namespace THIS_TEST
}  // namespace fretwork::geometry
