// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/pattern/search/connectivity.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace fretwork::pattern::detail {

/// The rules of an enumeration, compiled to masks of candidate edges. The problem refers to the filters,
/// which must outlive it.
template <class Word>
class SearchProblem {
  public:
    struct Load {
        int resource = 0;
        int amount = 0;
    };
    /// A resource. `too_heavy[c]` holds the edges whose load exceeds a remaining capacity c.
    struct Resource {
        int limit = 0;
        std::vector<Word> too_heavy;
    };

    SearchProblem(const NodeLayout& layout, std::span<const Filter> filters, const EdgeRange& range);

    EdgeRange range;
    Word candidates = 0;          ///< edges that no rule forbids by themselves
    std::vector<Word> conflicts;  ///< the conflicts of each edge
    std::vector<Resource> resources;
    std::vector<std::vector<Load>> loads;  ///< the loads of each edge on resources
    std::vector<Word> groups;              ///< a pattern has at least one edge of each group
    std::vector<const PredicateRule*> predicates;
    bool must_be_connected = false;
    bool must_have_no_articulation = false;

    Quotient quotient;
    std::vector<std::uint64_t> ends;  ///< for each edge, the orbits that it meets
    /// For each edge, the orbits at whose nodes at least two copies of the edge end.
    std::vector<std::uint64_t> double_ends;
    std::vector<Word> edges_at;  ///< for each orbit, the edges that meet it

  private:
    void add(const ConflictRule& rule);
    void add(const CapacityRule& rule);
    void add(const CoverRule& rule);
    void add(const GraphRule& rule);
    void add(const PredicateRule& rule);
    void index_orbits();
};

/// A node of the search tree: the chosen edges, and the later edges that may still be chosen.
template <class Word>
struct SearchNode {
    Word chosen = 0;
    Word available = 0;
};

/// A walk over the tree of all patterns that can still become valid. Each child of a node adds one later edge
/// to the node's edges.
template <class Word>
class Search {
  public:
    /// @param control  checked at each node that is entered, and every few thousand nodes below it
    Search(const SearchProblem<Word>& problem, const base::Control& control);

    /// Call visit(chosen, edge_count) for every valid pattern in the subtree of a node, in lexicographic
    /// order.
    template <class Visit>
    void walk(const SearchNode<Word>& node, const Visit& visit) {
        enter(node);
        descend(node, bit_count(node.chosen), visit);
    }

    /// True if the node's own set of edges is a valid pattern.
    bool is_valid(const SearchNode<Word>& node) {
        enter(node);
        return accepts(node.chosen, bit_count(node.chosen));
    }

    /// The children of a node that may lead to a valid pattern.
    std::vector<SearchNode<Word>> children(const SearchNode<Word>& node);

  private:
    /// The orbits that chosen edges meet at least once, and the orbits whose nodes chosen edges meet at least
    /// twice.
    struct Ends {
        std::uint64_t once = 0;
        std::uint64_t twice = 0;
    };

    void enter(const SearchNode<Word>& node);
    Word take(int edge, Word available);
    void release(int edge);
    [[nodiscard]] Ends with_edge(int edge) const;
    [[nodiscard]] bool is_hopeful(Word chosen, Word available) const;
    bool accepts(Word chosen, int edge_count);

    template <class Visit>
    void descend(SearchNode<Word> node, int edge_count, const Visit& visit) {
        constexpr unsigned kNodesBetweenChecks = 4096;
        if (++nodes_ % kNodesBetweenChecks == 0) control_->check();
        if (accepts(node.chosen, edge_count)) visit(node.chosen, edge_count);
        if (edge_count == problem_->range.most) return;
        for (Word left = node.available; left != 0;) {
            if (!is_hopeful(node.chosen, left)) return;
            const int edge = lowest_bit(left);
            left &= left - 1;
            const Ends before = ends_;
            ends_ = with_edge(edge);
            const SearchNode<Word> child{node.chosen | single<Word>(edge), take(edge, left)};
            if (is_hopeful(child.chosen, child.available)) descend(child, edge_count + 1, visit);
            release(edge);
            ends_ = before;
        }
    }

    const SearchProblem<Word>* problem_;
    const base::Control* control_;
    unsigned nodes_ = 0;  ///< nodes entered so far
    Connectivity connectivity_;
    std::vector<int> capacity_left_;
    Ends ends_;
};

extern template class SearchProblem<Word64>;
extern template class SearchProblem<Word128>;
extern template class Search<Word64>;
extern template class Search<Word128>;

}  // namespace fretwork::pattern::detail
