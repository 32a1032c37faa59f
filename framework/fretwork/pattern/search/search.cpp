// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/search/search.hpp>

#include <algorithm>

namespace fretwork::pattern::detail {

template <class Word>
SearchProblem<Word>::SearchProblem(const NodeLayout& layout, std::span<const Filter> filters,
                                   const EdgeRange& wanted)
    : range(wanted), quotient(layout) {
    const std::size_t count = layout.candidate_edges().size();
    range.most = std::min(range.most, static_cast<int>(count));
    for (std::size_t e = 0; e < count; ++e) candidates |= single<Word>(e);
    conflicts.resize(count);
    loads.resize(count);
    for (const Filter& filter : filters) std::visit([&](const auto& rule) { add(rule); }, filter.rule);
    index_orbits();
}

template <class Word>
void SearchProblem<Word>::add(const ConflictRule& rule) {
    for (std::size_t e = 0; e < conflicts.size(); ++e) {
        conflicts[e] |= to_word<Word>(rule.conflicts[e]);
        if (rule.conflicts[e].test(e)) candidates &= ~single<Word>(e);
    }
}

template <class Word>
void SearchProblem<Word>::add(const CapacityRule& rule) {
    for (const CapacityRule::Resource& given : rule.resources) {
        Resource resource{rule.limit, std::vector<Word>(rule.limit + 1)};
        for (std::size_t e = 0; e < loads.size(); ++e) {
            const int amount = given.loads[e];
            const Word edge = single<Word>(e);
            if (amount > 0) loads[e].push_back({static_cast<int>(resources.size()), amount});
            if (amount > rule.limit) candidates &= ~edge;
            for (int left = 0; left < std::min(amount, rule.limit + 1); ++left) {
                resource.too_heavy[left] |= edge;
            }
        }
        resources.push_back(std::move(resource));
    }
}

template <class Word>
void SearchProblem<Word>::add(const CoverRule& rule) {
    for (const EdgeGroup& group : rule.groups) groups.push_back(to_word<Word>(group.edges));
}

template <class Word>
void SearchProblem<Word>::add(const GraphRule& rule) {
    (rule.property == GraphRule::Property::Connected ? must_be_connected : must_have_no_articulation) = true;
}

template <class Word>
void SearchProblem<Word>::add(const PredicateRule& rule) {
    predicates.push_back(&rule);
}

template <class Word>
void SearchProblem<Word>::index_orbits() {
    edges_at.resize(quotient.orbit_count());
    for (std::size_t e = 0; e < quotient.links().size(); ++e) {
        const auto& [first, second, gain] = quotient.links()[e];
        const std::uint64_t a = std::uint64_t{1} << first;
        const std::uint64_t b = std::uint64_t{1} << second;
        const std::uint64_t center = quotient.center() < 0 ? 0 : std::uint64_t{1} << quotient.center();
        ends.push_back(a | b);
        double_ends.push_back((a & b) | ((a | b) & center));
        edges_at[first] |= single<Word>(e);
        edges_at[second] |= single<Word>(e);
    }
}

template <class Word>
Search<Word>::Search(const SearchProblem<Word>& problem, const base::Control& control)
    : problem_(&problem), control_(&control), connectivity_(problem.quotient) {}

/// Enter a node: set the state to which its chosen edges lead. Most subtrees that are entered end before the
/// next check in descend().
template <class Word>
void Search<Word>::enter(const SearchNode<Word>& node) {
    control_->check();
    capacity_left_.clear();
    for (const auto& resource : problem_->resources) capacity_left_.push_back(resource.limit);
    ends_ = {};
    for_each_bit(node.chosen, [&](int edge) {
        ends_ = with_edge(edge);
        take(edge, node.available);
    });
}

/// Load an edge onto its resources. Returns the edges that remain available.
template <class Word>
Word Search<Word>::take(int edge, Word available) {
    available &= ~problem_->conflicts[edge];
    for (const auto& [resource, amount] : problem_->loads[edge]) {
        int& left = capacity_left_[resource];
        left -= amount;
        available &= ~problem_->resources[resource].too_heavy[left];
    }
    return available;
}

template <class Word>
void Search<Word>::release(int edge) {
    for (const auto& [resource, amount] : problem_->loads[edge]) {
        capacity_left_[resource] += amount;
    }
}

template <class Word>
typename Search<Word>::Ends Search<Word>::with_edge(int edge) const {
    const std::uint64_t met = problem_->ends[edge];
    return {ends_.once | met, ends_.twice | (ends_.once & met) | problem_->double_ends[edge]};
}

/// False if no valid pattern can lie below a node, because a group has no edge left, or because a loose
/// end meets no available edge. A loose end is a node inside the tile where only one beam ends; the other end
/// of that beam is an articulation point.
template <class Word>
bool Search<Word>::is_hopeful(Word chosen, Word available) const {
    for (const Word group : problem_->groups) {
        if (((chosen | available) & group) == 0) return false;
    }
    if (!problem_->must_have_no_articulation || !problem_->must_be_connected) return true;
    for (std::uint64_t loose = ends_.once & ~ends_.twice & ~problem_->quotient.interface_orbits(); loose != 0;
         loose &= loose - 1) {
        if ((problem_->edges_at[std::countr_zero(loose)] & available) == 0) return false;
    }
    return true;
}

template <class Word>
bool Search<Word>::accepts(Word chosen, int edge_count) {
    if (edge_count < problem_->range.least || !is_hopeful(chosen, 0)) return false;
    if (problem_->must_be_connected || problem_->must_have_no_articulation) connectivity_.choose(chosen);
    if (problem_->must_be_connected && !connectivity_.is_connected()) return false;
    if (problem_->must_have_no_articulation && connectivity_.has_articulation()) return false;
    return std::all_of(problem_->predicates.begin(), problem_->predicates.end(),
                       [&](const PredicateRule* rule) { return rule->is_kept(to_pattern(chosen)); });
}

template <class Word>
std::vector<SearchNode<Word>> Search<Word>::children(const SearchNode<Word>& node) {
    std::vector<SearchNode<Word>> found;
    if (bit_count(node.chosen) == problem_->range.most) return found;
    for (Word left = node.available; left != 0;) {
        const int edge = lowest_bit(left);
        left &= left - 1;
        enter(node);
        ends_ = with_edge(edge);
        const SearchNode<Word> child{node.chosen | single<Word>(edge), take(edge, left)};
        if (is_hopeful(child.chosen, child.available)) found.push_back(child);
    }
    return found;
}

template class SearchProblem<Word64>;
template class SearchProblem<Word128>;
template class Search<Word64>;
template class Search<Word128>;

}  // namespace fretwork::pattern::detail
