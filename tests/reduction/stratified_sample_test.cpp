// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/stratified_sample.hpp>

#include <gtest/gtest.h>

#include <map>

namespace fretwork::reduction {
namespace THIS_TEST {

TEST(StratifiedSample, TakesEquallyManyOfEachStratumUntilItIsUsedUp) {
    std::vector<int> strata;
    for (const auto& [label, count] : std::map<int, int>{{2, 9}, {5, 429}, {10, 3}}) {
        strata.insert(strata.end(), static_cast<std::size_t>(count), label);
    }
    const auto chosen = stratified_sample(strata, 24);
    std::map<int, int> counts;
    for (const std::size_t index : chosen) ++counts[strata[index]];
    EXPECT_EQ(counts, (std::map<int, int>{{2, 9}, {5, 12}, {10, 3}}));
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    EXPECT_EQ(std::adjacent_find(chosen.begin(), chosen.end()), chosen.end());
}

TEST(StratifiedSample, TakesEverythingIfMoreIsAskedForThanThereIs) {
    EXPECT_EQ(stratified_sample(std::vector<int>{1, 1, 2}, 10), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_TRUE(stratified_sample({}, 3).empty());
}

TEST(StratifiedSample, IsSpreadWithinAStratum) {
    EXPECT_EQ(stratified_sample(std::vector<int>(9, 4), 3), (std::vector<std::size_t>{1, 4, 7}));
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
