// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/filter_catalogue.hpp>
#include <fretwork/pattern/rejections.hpp>
#include <fretwork/pattern/search/rule_test.hpp>

#include <algorithm>
#include <bit>

namespace fretwork::pattern {
namespace {

using detail::Word128;

constexpr std::size_t kMostGraphs = 1'000'000;

/// Call visit(graph) for every set of `size` edges, in lexicographic order, until it returns false.
template <class Visit>
bool for_each_of_size(int edge_count, int size, const Visit& visit) {
    std::vector<int> edges(size);
    for (int i = 0; i < size; ++i) edges[i] = i;
    for (;;) {
        Word128 graph = 0;
        for (const int edge : edges) graph |= detail::single<Word128>(edge);
        if (!visit(graph)) return false;
        int i = size - 1;
        while (i >= 0 && edges[i] == edge_count - size + i) --i;
        if (i < 0) return true;
        ++edges[i];
        for (int j = i + 1; j < size; ++j) edges[j] = edges[j - 1] + 1;
    }
}

/// For each rule, the graphs that break this rule alone, size after size. A rule with enough graphs gets none
/// of a larger size.
class Collector {
  public:
    Collector(const NodeLayout& layout, const std::vector<Filter>& filters, std::size_t wanted)
        : test_(layout, filters), wanted_(wanted), found_(filters.size()), is_done_(filters.size(), false) {}

    void collect(int edge_count, const EnumerationOptions& options) {
        const EdgeRange& range = options.edges;
        for (int size = range.least; size <= std::min(range.most, edge_count); ++size) {
            const bool goes_on = for_each_of_size(edge_count, size, [&](Word128 graph) {
                options.control.check();
                return look_at(graph);
            });
            if (!goes_on) return;
            for (std::size_t i = 0; i < found_.size(); ++i) is_done_[i] = found_[i].size() >= wanted_;
            if (std::find(is_done_.begin(), is_done_.end(), false) == is_done_.end()) return;
        }
    }
    /// The wanted number of a rule's graphs, evenly spread over all graphs found.
    [[nodiscard]] std::vector<Pattern> spread(std::size_t rule) const {
        const std::vector<Word128>& graphs = found_[rule];
        std::vector<Pattern> chosen;
        const std::size_t taken = std::min(wanted_, graphs.size());
        for (std::size_t i = 0; i < taken; ++i)
            chosen.push_back(detail::to_pattern(graphs[i * graphs.size() / taken]));
        return chosen;
    }

  private:
    bool look_at(Word128 graph) {
        const std::uint64_t broken = test_.broken(graph);
        const std::size_t rule = std::countr_zero(broken);
        if (std::has_single_bit(broken) && !is_done_[rule]) found_[rule].push_back(graph);
        return ++seen_ < kMostGraphs;
    }

    detail::RuleTest<Word128> test_;
    std::size_t wanted_;
    std::vector<std::vector<Word128>> found_;
    std::vector<bool> is_done_;
    std::size_t seen_ = 0;
};

}  // namespace

std::vector<Rejection> find_rejections(const NodeLayout& layout, const EnumerationOptions& options,
                                       std::size_t per_filter) {
    options.validate();
    const std::vector<Filter> filters = make_filters(layout, options.filters);
    Collector collector(layout, filters, per_filter);
    collector.collect(static_cast<int>(layout.candidate_edges().size()), options);
    std::vector<Rejection> rejections;
    for (std::size_t i = 0; i < filters.size(); ++i) {
        for (const Pattern& pattern : collector.spread(i))
            rejections.push_back({pattern, judge(layout, filters[i], pattern)});
    }
    return rejections;
}

}  // namespace fretwork::pattern
