// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/small_layouts.hpp"
#include "stops.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>
#include <fretwork/pattern/sample.hpp>
#include <fretwork/pattern/search/independent_sets.hpp>

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

#include <map>
#include <string>

namespace fretwork::pattern {
namespace THIS_TEST {

const NodeLayout& paper7() {
    static const NodeLayout layout = find_node_layout("paper7");
    return layout;
}

/// The probability of counts at least as uneven as these, if all cells are equally likely.
double chi_square_p_value(const std::map<std::string, int>& counts, std::size_t cells) {
    double draws = 0;
    for (const auto& [id, count] : counts) draws += count;
    const double expected = draws / static_cast<double>(cells);
    double statistic = expected * static_cast<double>(cells - counts.size());
    for (const auto& [id, count] : counts) statistic += (count - expected) * (count - expected) / expected;
    const boost::math::chi_squared_distribution<double> distribution(static_cast<double>(cells) - 1);
    return boost::math::cdf(boost::math::complement(distribution, statistic));
}

TEST(PatternSampler, StopsAtAnyLookWhileItCountsAndDraws) {
    test::expect_stops_at_any_look(
        [](const base::Control& control) {
            PatternSampler sampler(paper7(), {.edges = {}, .threads = 1, .control = control}, 7);
            (void)sampler.draw(10);
        },
        [] {});
}

// The sampler never sees the list, yet hits every one of the 1,824 patterns equally often.
TEST(PatternSampler, IsUniformOnALayoutThatCanBeListed) {
    constexpr int kDraws = 1824 * 40;
    std::map<std::string, int> counts;
    for (const Pattern& pattern : PatternSampler(paper7(), {}, 7).draw(kDraws))
        ++counts[pattern_id(paper7(), pattern)];
    EXPECT_EQ(counts.size(), 1824u);
    EXPECT_GT(chi_square_p_value(counts, 1824), 0.001);
}

TEST(PatternSampler, DrawsOnlyValidPatternsOfTheWantedSizes) {
    EnumerationOptions options;
    options.edges = {6, 7};
    options.filters.required = {parse_edge_group(paper7(), "n5")};
    const std::vector<Filter> filters = make_filters(paper7(), options.filters);
    for (const Pattern& pattern : PatternSampler(paper7(), options, 3).draw(200)) {
        EXPECT_TRUE(judge(paper7(), filters, pattern).accepted);
        EXPECT_TRUE(pattern.edge_count() == 6 || pattern.edge_count() == 7);
    }
}

TEST(PatternSampler, DependsOnTheSeedAndNotOnThreads) {
    const auto draw = [](std::uint64_t seed, int threads) {
        EnumerationOptions options;
        options.threads = threads;
        return PatternSampler(paper7(), options, seed).draw(50);
    };
    EXPECT_EQ(draw(1, 1), draw(1, 4));
    EXPECT_NE(draw(1, 1), draw(2, 1));
}

TEST(PatternSampler, TwoDrawsAreOneLongerDraw) {
    PatternSampler once(paper7(), {}, 5);
    PatternSampler twice(paper7(), {}, 5);
    std::vector<Pattern> patterns = twice.draw(30);
    for (const Pattern& pattern : twice.draw(20)) patterns.push_back(pattern);
    EXPECT_EQ(once.draw(50), patterns);
}

// 95 % intervals miss 5 times in 100; of 100 seeds, 14 misses or more would happen once in two thousand.
TEST(CountEstimate, IntervalHoldsTheTrueNumberAsOftenAsItSays) {
    int misses = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const CountEstimate estimate = PatternSampler(paper7(), {}, seed).estimate(2000);
        EXPECT_LE(estimate.lower, estimate.valid);
        EXPECT_LE(estimate.valid, estimate.upper);
        if (estimate.lower > 1824 || estimate.upper < 1824) ++misses;
    }
    EXPECT_LT(misses, 14);
}

TEST(CountEstimate, OfNoProposalIsZero) {
    EnumerationOptions options;
    options.edges = {17, 17};
    const PatternSampler sampler(paper7(), options, 1);
    EXPECT_EQ(sampler.estimate(10).upper, 0.0);
    EXPECT_THROW(PatternSampler(paper7(), options, 1).draw(1), base::NumericalError);
    EXPECT_THROW(static_cast<void>(sampler.estimate(0)), base::InputError);
}

// By hand: a path of four edges a-b-c-d in conflict has 1 + 4x + 3x^2 independent sets.
TEST(IndependentSets, OfAPathAreKnown) {
    const std::vector<detail::Word64> path{0b0010, 0b0101, 0b1010, 0b0100};
    const detail::IndependentSets<detail::Word64> sets(path, 0b1111, 100);
    ASSERT_TRUE(sets.is_counted());
    ASSERT_EQ(sets.counts().size(), 3u);
    EXPECT_EQ(count_text(sets.counts()[0]), "1");
    EXPECT_EQ(count_text(sets.counts()[1]), "4");
    EXPECT_EQ(count_text(sets.counts()[2]), "3");
    std::map<std::string, int> drawn;
    for (std::uint64_t i = 0; i < 3000; ++i) {
        detail::WideRandom random(1, i);
        ++drawn[std::to_string(sets.draw(2, random))];
    }
    EXPECT_EQ(drawn.size(), 3u);
    EXPECT_GT(chi_square_p_value(drawn, 3), 0.001);
}

TEST(IndependentSets, GiveUpBeyondTheirMemory) {
    std::vector<detail::Word64> cycle;
    for (int i = 0; i < 30; ++i)
        cycle.push_back(detail::single<detail::Word64>((i + 1) % 30) |
                        detail::single<detail::Word64>((i + 29) % 30));
    EXPECT_FALSE(detail::IndependentSets<detail::Word64>(cycle, (1u << 30) - 1, 3).is_counted());
    EXPECT_TRUE(detail::IndependentSets<detail::Word64>(cycle, (1u << 30) - 1, 1000).is_counted());
}

}  // namespace THIS_TEST
}  // namespace fretwork::pattern
