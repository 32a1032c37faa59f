// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/census.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>
#include <fretwork/pattern/sameness.hpp>
#include <fretwork/pattern/sample.hpp>
#include <fretwork/pattern/search/rule_test.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>

namespace fretwork::pattern {
namespace {

using detail::Word64;

const NodeLayout& paper7() {
    static const NodeLayout layout = find_node_layout("paper7");
    return layout;
}

/// Four radial pairs, two face nodes: 49 candidate edges, 6,540,827 valid patterns.
const NodeLayout& fifths() {
    static const NodeLayout layout = find_node_layout("fifths12");
    return layout;
}

/// The baseline: what the paper does. Every graph is made first and judged afterwards, by Boost.Graph.
std::uint64_t count_by_judging_every_graph(const NodeLayout& layout) {
    const std::vector<Filter> filters = make_filters(layout);
    std::uint64_t valid = 0;
    for (Word64 graph = 1; graph < Word64{1} << layout.candidate_edges().size(); ++graph) {
        const Pattern pattern = detail::to_pattern(graph);
        if (pattern.edge_count() > 1 && judge(layout, filters, pattern).accepted) ++valid;
    }
    return valid;
}

/// The baseline where 2^E is out of reach: backtracking over conflicts alone, everything else tested
/// afterwards.
class PlainBacktracking {
  public:
    explicit PlainBacktracking(const NodeLayout& layout)
        : filters_(make_filters(layout)),
          test_(layout, filters_),
          conflicts_(layout.candidate_edges().size()) {
        for (const Filter& filter : filters_) {
            const auto* rule = std::get_if<ConflictRule>(&filter.rule);
            for (std::size_t e = 0; rule != nullptr && e < conflicts_.size(); ++e)
                conflicts_[e] |= detail::to_word<Word64>(rule->conflicts[e]);
        }
    }
    std::uint64_t count() { return descend(0, (Word64{1} << conflicts_.size()) - 1); }

  private:
    std::uint64_t descend(Word64 chosen, Word64 available) {
        std::uint64_t valid = detail::bit_count(chosen) > 1 && test_.broken(chosen) == 0 ? 1 : 0;
        for (Word64 left = available; left != 0;) {
            const int edge = detail::lowest_bit(left);
            left &= left - 1;
            valid += descend(chosen | detail::single<Word64>(edge),
                             left & ~conflicts_[static_cast<std::size_t>(edge)]);
        }
        return valid;
    }

    std::vector<Filter> filters_;
    detail::RuleTest<Word64> test_;
    std::vector<Word64> conflicts_;
};

void require(benchmark::State& state, std::uint64_t found, std::uint64_t expected) {
    if (found != expected) state.SkipWithError("the count is wrong");
}

void count_paper7(benchmark::State& state) {
    for (auto _ : state) require(state, count_patterns(paper7()).total(), 1824);
}
BENCHMARK(count_paper7)->Unit(benchmark::kMillisecond)->UseRealTime();

void count_paper7_by_judging_every_graph(benchmark::State& state) {
    for (auto _ : state) require(state, count_by_judging_every_graph(paper7()), 1824);
}
BENCHMARK(count_paper7_by_judging_every_graph)->Unit(benchmark::kMillisecond)->UseRealTime();

void census_paper7(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(take_census(paper7()));
}
BENCHMARK(census_paper7)->Unit(benchmark::kMillisecond)->UseRealTime();

void count_fifths(benchmark::State& state) {
    EnumerationOptions options;
    options.threads = static_cast<int>(state.range(0));
    for (auto _ : state) require(state, count_patterns(fifths(), options).total(), 6540827);
}
BENCHMARK(count_fifths)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void count_fifths_by_plain_backtracking(benchmark::State& state) {
    for (auto _ : state) require(state, PlainBacktracking(fifths()).count(), 6540827);
}
BENCHMARK(count_fifths_by_plain_backtracking)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void estimate_fifths_from_10000_trials(benchmark::State& state) {
    const PatternSampler sampler(fifths(), {}, 1);
    for (auto _ : state) benchmark::DoNotOptimize(sampler.estimate(10'000));
}
BENCHMARK(estimate_fifths_from_10000_trials)->Unit(benchmark::kMillisecond)->UseRealTime();

void classify_paper7(benchmark::State& state) {
    const std::vector<Pattern> patterns = enumerate_patterns(paper7());
    for (auto _ : state) benchmark::DoNotOptimize(find_sameness(paper7(), patterns));
}
BENCHMARK(classify_paper7)->Unit(benchmark::kMillisecond)->UseRealTime();

void place_a_fan(benchmark::State& state) {
    const Fan fan = make_fan(paper7(), parse_pattern_id(paper7(), "0-1+1-5+2-6+4-6+5-6"), 6);
    const geometry::Polygon hexagon = geometry::regular_polygon(6, 0.026);
    for (auto _ : state) benchmark::DoNotOptimize(place_fan(paper7(), fan, hexagon));
}
BENCHMARK(place_a_fan);

}  // namespace
}  // namespace fretwork::pattern
