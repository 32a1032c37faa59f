// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/search/search.hpp>

#include <algorithm>
#include <numeric>
#include <optional>

namespace fretwork::pattern {
namespace {

using detail::Search;
using detail::SearchNode;
using detail::SearchProblem;

/// A piece of the search tree: a node alone, or a node with its subtree.
template <class Word>
struct Piece {
    SearchNode<Word> node;
    bool with_subtree = false;
};

/// Searches a tree in pieces, on several threads.
template <class Word>
class PieceSearch {
  public:
    PieceSearch(const SearchProblem<Word>& problem, const EnumerationOptions& options)
        : problem_(problem), options_(options) {}

    /// The number of valid patterns with k edges, for k from 0 to `candidate_count`.
    [[nodiscard]] PatternCount count(std::size_t candidate_count) const {
        const std::vector<Piece<Word>> pieces = pieces_of_tree();
        const PatternCount nothing{std::vector<std::uint64_t>(candidate_count + 1)};
        std::vector<PatternCount> parts(pieces.size(), nothing);
        base::ParallelTask task(options_.control, "search", pieces.size());
        base::parallel_for(pieces.size(), options_.threads, [&](std::size_t i) {
            search(pieces[i], [&](Word, int edges) { ++parts[i].by_edges[edges]; });
            task.advance();
        });
        PatternCount sum = nothing;
        for (const PatternCount& part : parts) {
            for (std::size_t k = 0; k <= candidate_count; ++k) sum.by_edges[k] += part.by_edges[k];
        }
        return sum;
    }

    /// Call visit(pattern) for every valid pattern in lexicographic order, on this thread.
    template <class Visit>
    void stream(const Visit& visit) const {
        const std::vector<Piece<Word>> pieces = pieces_of_tree();
        base::ParallelTask task(options_.control, "search", pieces.size());
        stream_pieces(pieces, visit, [&task] { task.advance(); });
    }

  private:
    using Found = std::optional<std::vector<Word>>;

    /// The whole tree, cut so that its pieces, one after the other, give the lexicographic order.
    [[nodiscard]] std::vector<Piece<Word>> pieces_of_tree() const {
        // The search of a small layout takes milliseconds, and more pieces would only cost time.
        constexpr int kSmallLayout = 20;
        const int depth = detail::bit_count(problem_.candidates) <= kSmallLayout ? 1 : 3;
        return cut({0, problem_.candidates}, depth);
    }

    [[nodiscard]] std::vector<Piece<Word>> cut(const SearchNode<Word>& node, int depth) const {
        std::vector<Piece<Word>> pieces{{node, depth == 0}};
        if (depth == 0) return pieces;
        for (const SearchNode<Word>& child : Search<Word>(problem_, options_.control).children(node)) {
            const auto below = cut(child, depth - 1);
            pieces.insert(pieces.end(), below.begin(), below.end());
        }
        return pieces;
    }

    template <class Visit>
    void search(const Piece<Word>& piece, const Visit& visit) const {
        Search<Word> search(problem_, options_.control);
        if (piece.with_subtree) {
            search.walk(piece.node, visit);
        } else if (search.is_valid(piece.node)) {
            visit(piece.node.chosen, detail::bit_count(piece.node.chosen));
        }
    }

    /// The patterns of a piece; nothing if there are more than may be kept.
    [[nodiscard]] Found find(const Piece<Word>& piece) const {
        struct TooMany {};
        std::vector<Word> found;
        try {
            search(piece, [&](Word chosen, int) {
                if (found.size() == options_.most_kept) throw TooMany{};
                found.push_back(chosen);
            });
        } catch (const TooMany&) {
            return std::nullopt;
        }
        return found;
    }

    /// Search a batch of pieces in parallel, then report the patterns in order. A piece with too many
    /// patterns is divided, and its parts are searched one after the other when the turn of the piece comes.
    template <class Visit>
    void stream_pieces(const std::vector<Piece<Word>>& pieces, const Visit& visit,
                       const std::function<void()>& done) const {
        constexpr std::size_t kBatch = 256;
        for (std::size_t start = 0; start < pieces.size(); start += kBatch) {
            std::vector<Found> batch(std::min(kBatch, pieces.size() - start));
            base::parallel_for(batch.size(), options_.threads, [&](std::size_t i) {
                batch[i] = find(pieces[start + i]);
                if (batch[i]) done();
            });
            for (std::size_t i = 0; i < batch.size(); ++i) {
                options_.control.check();
                if (batch[i]) {
                    for (const Word chosen : *batch[i]) visit(chosen);
                    continue;
                }
                stream_pieces(cut(pieces[start + i].node, 1), visit, [] {});
                done();
            }
        }
    }

    const SearchProblem<Word>& problem_;
    const EnumerationOptions& options_;
};

/// Call body(problem) with the search problem of the layout, in the narrowest words that hold its edges.
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
        throw base::InputError("the numbers of edges are a range A..B with 1 <= A <= B, and " +
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
    if (most_kept < 1) throw base::InputError("the most patterns kept before their turn must be at least 1");
    if (threads < 0) throw base::InputError("the number of threads is 0 (all) or more");
}

std::uint64_t PatternCount::total() const {
    return std::accumulate(by_edges.begin(), by_edges.end(), std::uint64_t{0});
}

PatternCount for_each_pattern(const NodeLayout& layout, const EnumerationOptions& options,
                              const std::function<void(const Pattern&)>& visit) {
    PatternCount count{std::vector<std::uint64_t>(layout.candidate_edges().size() + 1)};
    return with_problem(layout, options, [&](const auto& problem) {
        PieceSearch(problem, options).stream([&](auto chosen) {
            ++count.by_edges[detail::bit_count(chosen)];
            visit(detail::to_pattern(chosen));
        });
        return count;
    });
}

std::vector<Pattern> enumerate_patterns(const NodeLayout& layout, const EnumerationOptions& options) {
    std::vector<Pattern> patterns;
    for_each_pattern(layout, options, [&](const Pattern& pattern) { patterns.push_back(pattern); });
    return patterns;
}

PatternCount count_patterns(const NodeLayout& layout, const EnumerationOptions& options) {
    return with_problem(layout, options, [&](const auto& problem) {
        return PieceSearch(problem, options).count(layout.candidate_edges().size());
    });
}

}  // namespace fretwork::pattern
