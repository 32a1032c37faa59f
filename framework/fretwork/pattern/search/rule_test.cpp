// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/search/rule_test.hpp>

#include <algorithm>

namespace fretwork::pattern::detail {
namespace {

template <class Word>
std::vector<Word> masks_of(const Rule& rule) {
    std::vector<Word> masks;
    if (const auto* conflict = std::get_if<ConflictRule>(&rule)) {
        for (const Pattern::Bits& bits : conflict->conflicts) masks.push_back(to_word<Word>(bits));
    }
    if (const auto* cover = std::get_if<CoverRule>(&rule)) {
        for (const EdgeGroup& group : cover->groups) masks.push_back(to_word<Word>(group.edges));
    }
    return masks;
}

template <class Word>
bool exceeds(const CapacityRule& rule, Word edges) {
    return std::any_of(rule.resources.begin(), rule.resources.end(),
                       [&](const CapacityRule::Resource& resource) {
                           int load = 0;
                           for_each_bit(edges, [&](int edge) { load += resource.loads[edge]; });
                           return load > rule.limit;
                       });
}

}  // namespace

template <class Word>
RuleTest<Word>::RuleTest(const NodeLayout& layout, std::span<const Filter> filters)
    : quotient_(layout), connectivity_(quotient_) {
    for (const Filter& filter : filters) rules_.push_back({&filter.rule, masks_of<Word>(filter.rule)});
}

template <class Word>
bool RuleTest<Word>::breaks(const Compiled& compiled, Word edges) const {
    if (std::holds_alternative<ConflictRule>(*compiled.rule)) {
        bool conflict = false;
        for_each_bit(edges, [&](int edge) { conflict |= (compiled.masks[edge] & edges) != 0; });
        return conflict;
    }
    if (std::holds_alternative<CoverRule>(*compiled.rule))
        return std::any_of(compiled.masks.begin(), compiled.masks.end(),
                           [&](Word group) { return (group & edges) == 0; });
    if (const auto* capacity = std::get_if<CapacityRule>(compiled.rule)) return exceeds(*capacity, edges);
    if (const auto* graph = std::get_if<GraphRule>(compiled.rule))
        return graph->property == GraphRule::Property::Connected ? !connectivity_.is_connected()
                                                                 : connectivity_.has_articulation();
    return !std::get<PredicateRule>(*compiled.rule).is_kept(to_pattern(edges));
}

template <class Word>
std::uint64_t RuleTest<Word>::broken(Word edges) {
    connectivity_.choose(edges);
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < rules_.size(); ++i) {
        if (breaks(rules_[i], edges)) result |= std::uint64_t{1} << i;
    }
    return result;
}

template class RuleTest<Word64>;
template class RuleTest<Word128>;

}  // namespace fretwork::pattern::detail
