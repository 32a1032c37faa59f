// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/pattern/detail/search.hpp>
#include <fretwork/pattern/enumerate.hpp>

#include <algorithm>
#include <numeric>

namespace fretwork::pattern {
namespace {

using detail::Search;
using detail::SearchNode;
using detail::SearchProblem;

/// A piece of the search tree: a node alone, or with all that is below it.
template <class Word>
struct Task {
    SearchNode<Word> node;
    bool with_subtree = false;
};

/// Cuts the tree into pieces whose concatenation is the whole in lexicographic order.
template <class Word>
class TaskList {
  public:
    explicit TaskList(const SearchProblem<Word>& problem) : search_(problem) {
        // Where a whole search takes milliseconds, more pieces would only cost time.
        constexpr int kSmallLayout = 20;
        depth_ = detail::bit_count(problem.candidates) <= kSmallLayout ? 1 : 3;
        cut({0, problem.candidates}, 0);
    }
    std::vector<Task<Word>> take() { return std::move(tasks_); }

  private:
    void cut(const SearchNode<Word>& node, int depth) {
        tasks_.push_back({node, depth == depth_});
        if (depth == depth_) return;
        for (const SearchNode<Word>& child : search_.children(node)) cut(child, depth + 1);
    }

    Search<Word> search_;
    int depth_ = 0;
    std::vector<Task<Word>> tasks_;
};

template <class Word, class Visit>
void run(Search<Word>& search, const Task<Word>& task, const Visit& visit) {
    if (task.with_subtree) {
        search.walk(task.node, visit);
    } else if (search.is_valid(task.node)) {
        visit(task.node.chosen, detail::bit_count(task.node.chosen));
    }
}

void add(PatternCount& sum, const PatternCount& part) {
    for (std::size_t k = 0; k < part.by_edges.size(); ++k) sum.by_edges[k] += part.by_edges[k];
}

template <class Word>
PatternCount count_in(const SearchProblem<Word>& problem, std::size_t candidate_count, int threads) {
    const std::vector<Task<Word>> tasks = TaskList<Word>(problem).take();
    const PatternCount nothing{std::vector<std::uint64_t>(candidate_count + 1)};
    std::vector<PatternCount> parts(tasks.size(), nothing);
    base::parallel_for(tasks.size(), threads, [&](std::size_t i) {
        Search<Word> search(problem);
        run(search, tasks[i], [&](Word, int edges) { ++parts[i].by_edges[static_cast<std::size_t>(edges)]; });
    });
    PatternCount sum = nothing;
    for (const PatternCount& part : parts) add(sum, part);
    return sum;
}

/// Pieces are searched a batch at a time, in parallel, and then told in order.
template <class Word>
PatternCount stream(const SearchProblem<Word>& problem, std::size_t candidate_count, int threads,
                    const std::function<void(const Pattern&)>& visit) {
    constexpr std::size_t kBatch = 256;
    const std::vector<Task<Word>> tasks = TaskList<Word>(problem).take();
    PatternCount sum{std::vector<std::uint64_t>(candidate_count + 1)};
    for (std::size_t start = 0; start < tasks.size(); start += kBatch) {
        std::vector<std::vector<Word>> found(std::min(kBatch, tasks.size() - start));
        base::parallel_for(found.size(), threads, [&](std::size_t i) {
            Search<Word> search(problem);
            run(search, tasks[start + i], [&](Word chosen, int) { found[i].push_back(chosen); });
        });
        for (const std::vector<Word>& part : found) {
            for (const Word chosen : part) {
                ++sum.by_edges[static_cast<std::size_t>(detail::bit_count(chosen))];
                visit(detail::to_pattern(chosen));
            }
        }
    }
    return sum;
}

/// Call body(problem) with the layout's problem in words just wide enough.
template <class Body>
PatternCount with_problem(const NodeLayout& layout, const EnumerationOptions& options, const Body& body) {
    options.validate();
    const std::vector<Filter> filters = make_filters(layout, options.filters);
    constexpr std::size_t kNarrow = 64;
    if (layout.candidate_edges().size() <= kNarrow)
        return body(SearchProblem<detail::Word64>(layout, filters, options.edges));
    return body(SearchProblem<detail::Word128>(layout, filters, options.edges));
}

}  // namespace

void EdgeRange::validate() const {
    if (least < 1 || most < least)
        throw base::InputError("the numbers of edges run from a least one of 1 or more upwards, and " +
                               std::to_string(least) + ".." + std::to_string(most) + " was given");
}

EdgeRange default_edge_range(const NodeLayout& layout) {
    constexpr EdgeRange kPaper{2, 11};
    const int all = static_cast<int>(layout.candidate_edges().size());
    return layout.name() == "paper7" ? kPaper : EdgeRange{std::min(2, all), all};
}

void EnumerationOptions::validate() const {
    edges.validate();
    filters.scale.validate();
    if (threads < 0) throw base::InputError("the number of threads is 0 (all) or more");
}

std::uint64_t PatternCount::total() const {
    return std::accumulate(by_edges.begin(), by_edges.end(), std::uint64_t{0});
}

PatternCount for_each_pattern(const NodeLayout& layout, const EnumerationOptions& options,
                              const std::function<void(const Pattern&)>& visit) {
    return with_problem(layout, options, [&](const auto& problem) {
        return stream(problem, layout.candidate_edges().size(), options.threads, visit);
    });
}

std::vector<Pattern> enumerate_patterns(const NodeLayout& layout, const EnumerationOptions& options) {
    std::vector<Pattern> patterns;
    for_each_pattern(layout, options, [&](const Pattern& pattern) { patterns.push_back(pattern); });
    return patterns;
}

PatternCount count_patterns(const NodeLayout& layout, const EnumerationOptions& options) {
    return with_problem(layout, options, [&](const auto& problem) {
        return count_in(problem, layout.candidate_edges().size(), options.threads);
    });
}

}  // namespace fretwork::pattern
