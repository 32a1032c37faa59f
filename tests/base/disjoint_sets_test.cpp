// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/disjoint_sets.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace fretwork::base {
namespace THIS_TEST {

std::vector<std::size_t> firsts(DisjointSets& sets, std::size_t count) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(sets.first_of(i));
    return all;
}

TEST(DisjointSets, EachIsAloneAtFirst) {
    DisjointSets sets(3);
    EXPECT_THAT(firsts(sets, 3), testing::ElementsAre(0, 1, 2));
}

TEST(DisjointSets, ASetIsNamedByItsFirstMember) {
    DisjointSets sets(6);
    sets.unite(5, 3);
    sets.unite(4, 5);
    sets.unite(1, 1);
    EXPECT_THAT(firsts(sets, 6), testing::ElementsAre(0, 1, 2, 3, 3, 3));
    sets.unite(4, 0);
    EXPECT_THAT(firsts(sets, 6), testing::ElementsAre(0, 1, 2, 0, 0, 0));
}

TEST(DisjointSets, TheOrderOfWhatIsUnitedDoesNotMatter) {
    constexpr std::size_t kCount = 60;
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> any(0, kCount - 1);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (int i = 0; i < 40; ++i) pairs.emplace_back(any(random), any(random));
    std::vector<std::size_t> expected;
    for (int round = 0; round < 20; ++round) {
        DisjointSets sets(kCount);
        for (const auto& [a, b] : pairs) sets.unite(a, b);
        if (round == 0) expected = firsts(sets, kCount);
        EXPECT_EQ(firsts(sets, kCount), expected);
        std::ranges::shuffle(pairs, random);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::base
