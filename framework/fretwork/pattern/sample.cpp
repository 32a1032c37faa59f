// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/pattern/sample.hpp>
#include <fretwork/pattern/search/independent_sets.hpp>
#include <fretwork/pattern/search/rule_test.hpp>

#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <atomic>

namespace fretwork::pattern {
namespace {

using detail::Word128;

/// The number of trials that one thread makes at a time, and the number of such pieces between two looks at
/// the results.
constexpr std::uint64_t kPiece = 256;
constexpr std::uint64_t kPiecesInABatch = 16;
/// The largest number of parts that the count stores, which take a few hundred megabytes at most.
constexpr std::size_t kMostParts = 1'000'000;

/// The conflicts of each edge, under all rules.
std::vector<Word128> all_conflicts(const std::vector<Filter>& filters, std::size_t edge_count) {
    std::vector<Word128> conflicts(edge_count);
    for (const Filter& filter : filters) {
        const auto* rule = std::get_if<ConflictRule>(&filter.rule);
        for (std::size_t e = 0; rule != nullptr && e < edge_count; ++e)
            conflicts[e] |= detail::to_word<Word128>(rule->conflicts[e]);
    }
    return conflicts;
}

Word128 all_edges(std::size_t edge_count) {
    Word128 edges = 0;
    for (std::size_t e = 0; e < edge_count; ++e) edges |= detail::single<Word128>(e);
    return edges;
}

}  // namespace

struct PatternSampler::Impl {
    Impl(const NodeLayout& given, const EnumerationOptions& wanted, std::uint64_t seed_)
        : layout(given),
          options(wanted),
          seed(seed_),
          filters(make_filters(given, wanted.filters)),
          sets(all_conflicts(filters, given.candidate_edges().size()),
               all_edges(given.candidate_edges().size()), kMostParts, wanted.control) {
        if (!sets.is_counted())
            throw base::NumericalError(
                "the layout '" + layout.name() +
                "' has too many graphs without conflicts to count them; forbid some nodes or edges");
        const auto end = std::min(static_cast<std::size_t>(options.edges.most) + 1, sets.counts().size());
        for (std::size_t k = options.edges.least; k < end; ++k) proposals += sets.counts()[k];
    }

    /// The graph of one trial. Pre: there are proposals.
    [[nodiscard]] Word128 propose(std::uint64_t trial) const {
        detail::WideRandom random(seed, trial);
        GraphCount pick = random.below(proposals);
        int size = options.edges.least;
        while (pick >= sets.counts()[size]) pick -= sets.counts()[size++];
        return sets.draw(size, random);
    }

    /// Call visit(piece, graph) for every valid graph of `count` trials, the first of which is trial `first`.
    /// Pieces run in parallel; within a piece, the graphs come in the order of the trials.
    template <class Visit>
    void try_all(std::uint64_t first, std::uint64_t count, const Visit& visit) const {
        base::parallel_for((count + kPiece - 1) / kPiece, options.threads, [&](std::size_t piece) {
            options.control.check();
            detail::RuleTest<Word128> test(layout, filters);
            const std::uint64_t start = piece * kPiece;
            for (std::uint64_t i = start; i < std::min(count, start + kPiece); ++i) {
                const Word128 proposal = propose(first + i);
                if (test.broken(proposal) == 0) visit(piece, proposal);
            }
        });
    }

    /// The number of valid graphs of the first `trials` trials. The trials are made in parts, and progress is
    /// reported after each part.
    [[nodiscard]] std::uint64_t count_hits(std::uint64_t trials) const {
        constexpr std::uint64_t kPart = 64 * kPiece;
        const base::Task task(options.control, "trials", trials);
        std::atomic<std::uint64_t> hits{0};
        for (std::uint64_t first = 0; first < trials; first += kPart) {
            const std::uint64_t count = std::min(kPart, trials - first);
            try_all(first, count, [&](std::size_t, Word128) { ++hits; });
            task.update(first + count);
        }
        return hits;
    }

    NodeLayout layout;
    EnumerationOptions options;
    std::uint64_t seed;
    std::vector<Filter> filters;
    detail::IndependentSets<Word128> sets;
    GraphCount proposals = 0;
    std::uint64_t next_trial = 0;
    std::vector<Pattern> drawn;  ///< patterns found but not yet returned
};

PatternSampler::PatternSampler(const NodeLayout& layout, const EnumerationOptions& options,
                               std::uint64_t seed) {
    options.validate();
    impl_ = std::make_unique<Impl>(layout, options, seed);
}
PatternSampler::PatternSampler(PatternSampler&&) noexcept = default;
PatternSampler& PatternSampler::operator=(PatternSampler&&) noexcept = default;
PatternSampler::~PatternSampler() = default;

std::vector<Pattern> PatternSampler::draw(std::size_t count, std::uint64_t most_trials) {
    Impl& impl = *impl_;
    const bool is_hopeless = impl.proposals == 0;
    const base::Task task(impl.options.control, "draw", count);
    for (std::uint64_t fruitless = 0; impl.drawn.size() < count;) {
        if (is_hopeless)
            throw base::NumericalError(
                "the layout '" + impl.layout.name() +
                "' has no graph without conflicts and with the wanted number of edges");
        if (fruitless >= most_trials)
            throw base::NumericalError("no valid pattern of the layout '" + impl.layout.name() +
                                       "' was found in " + std::to_string(fruitless) + " trials");
        std::vector<std::vector<Pattern>> found(kPiecesInABatch);
        impl.try_all(impl.next_trial, kPiece * kPiecesInABatch, [&](std::size_t piece, Word128 graph) {
            found[piece].push_back(detail::to_pattern(graph));
        });
        impl.next_trial += kPiece * kPiecesInABatch;
        const std::size_t before = impl.drawn.size();
        for (const auto& piece : found) impl.drawn.insert(impl.drawn.end(), piece.begin(), piece.end());
        fruitless = impl.drawn.size() > before ? 0 : fruitless + kPiece * kPiecesInABatch;
        task.update(std::min(count, impl.drawn.size()));
    }
    const auto end = impl.drawn.begin() + count;
    std::vector<Pattern> result(impl.drawn.begin(), end);
    impl.drawn.erase(impl.drawn.begin(), end);
    return result;
}

CountEstimate PatternSampler::estimate(std::uint64_t trials) const {
    if (trials == 0) throw base::InputError("an estimate needs at least one trial");
    CountEstimate estimate;
    estimate.trials = trials;
    estimate.proposals = impl_->proposals;
    if (impl_->proposals == 0) return estimate;
    estimate.hits = impl_->count_hits(trials);
    using Binomial = boost::math::binomial_distribution<double>;
    const double tail = (1.0 - estimate.confidence) / 2.0;
    const auto n = static_cast<double>(trials);
    const auto k = static_cast<double>(estimate.hits);
    const auto all = static_cast<double>(impl_->proposals);
    estimate.valid = all * k / n;
    estimate.lower = all * Binomial::find_lower_bound_on_p(n, k, tail);
    estimate.upper = all * Binomial::find_upper_bound_on_p(n, k, tail);
    return estimate;
}

}  // namespace fretwork::pattern
