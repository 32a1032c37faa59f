// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <algorithm>
#include <optional>

namespace fretwork::pattern {
namespace {

std::string edge_text(const Edge& edge) {
    return std::to_string(edge.first.value) + "-" + std::to_string(edge.second.value);
}

std::optional<LayoutNodeIndex> parse_node(std::string_view text) {
    const bool has_sign = text.starts_with('+') || text.starts_with('-');
    const auto number = base::read_number<int>(text);
    if (has_sign || !number) return std::nullopt;
    return LayoutNodeIndex(*number);
}

std::optional<Edge> parse_edge(std::string_view text) {
    const auto dash = text.find('-');
    if (dash == std::string_view::npos) return std::nullopt;
    const auto first = parse_node(text.substr(0, dash));
    const auto second = parse_node(text.substr(dash + 1));
    if (!first || !second) return std::nullopt;
    return Edge{std::min(*first, *second), std::max(*first, *second)};
}

std::string_view without_layout_name(const NodeLayout& layout, std::string_view id) {
    const auto colon = id.rfind(':');
    if (colon == std::string_view::npos) return id;
    if (id.substr(0, colon) != layout.name()) {
        throw base::InputError("'" + std::string(id) + "' belongs to another layout than '" + layout.name() +
                               "'");
    }
    return id.substr(colon + 1);
}

}  // namespace

std::vector<EdgeIndex> Pattern::edges() const {
    std::vector<EdgeIndex> chosen;
    for (std::size_t e = edges_._Find_first(); e < edges_.size(); e = edges_._Find_next(e)) {
        chosen.emplace_back(e);
    }
    return chosen;
}

EdgeIndex find_edge(const NodeLayout& layout, std::string_view text) {
    const std::optional<Edge> edge = parse_edge(text);
    if (!edge) {
        throw base::InputError("'" + std::string(text) +
                               "' is not an edge: expected two nodes joined by '-', as in 0-1");
    }
    const auto& candidates = layout.candidate_edges();
    const auto found = std::lower_bound(candidates.begin(), candidates.end(), *edge);
    if (found == candidates.end() || *found != *edge) {
        throw base::InputError("'" + std::string(text) + "' is not a candidate edge of the layout '" +
                               layout.name() + "'");
    }
    return EdgeIndex(found - candidates.begin());
}

std::string pattern_id(const NodeLayout& layout, const Pattern& pattern) {
    std::string id;
    for (const EdgeIndex edge : pattern.edges()) {
        id += (id.empty() ? "" : "+") + edge_text(layout.candidate_edges()[edge]);
    }
    return id;
}

Pattern parse_pattern_id(const NodeLayout& layout, std::string_view id) {
    Pattern::Bits chosen;
    for (const std::string& text : base::split(without_layout_name(layout, id), '+')) {
        const std::size_t edge = find_edge(layout, text);
        if (chosen.test(edge)) {
            throw base::InputError("the pattern id '" + std::string(id) + "' names the edge " + text +
                                   " twice");
        }
        chosen.set(edge);
    }
    return Pattern(chosen);
}

NamedPattern named(const NodeLayout& layout, const Pattern& pattern) {
    return {pattern_id(layout, pattern), pattern};
}

NamedPattern parse_named_pattern(const NodeLayout& layout, std::string_view id) {
    return named(layout, parse_pattern_id(layout, id));
}

std::vector<NamedPattern> parse_named_patterns(const NodeLayout& layout, std::span<const std::string> ids) {
    std::vector<NamedPattern> patterns;
    for (const std::string& id : ids) patterns.push_back(parse_named_pattern(layout, id));
    return patterns;
}

std::vector<std::string> ids_of(std::span<const NamedPattern> patterns) {
    std::vector<std::string> ids;
    for (const NamedPattern& pattern : patterns) ids.push_back(pattern.id);
    return ids;
}

}  // namespace fretwork::pattern
