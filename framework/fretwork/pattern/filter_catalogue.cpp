// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/filters/filters.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::pattern {
namespace {

constexpr double kFifteenDegrees = std::numbers::pi / 12;
/// The largest number of filters; the census has one bit for each.
constexpr std::size_t kMostFilters = 64;

// The paper's six come first, in the order of its Table 1.
constexpr FilterKind kCatalogue[] = {
    {"intersecting", "two edges cross", FilterParameter::None, true, 0.0, filters::make_intersecting},
    {"no_interface", "an interface node has no edge", FilterParameter::None, true, 0.0,
     filters::make_no_interface},
    {"multiple_components", "the fan (the pattern, repeated around the tile) is not connected",
     FilterParameter::None, true, 0.0, filters::make_multiple_components},
    {"articulation", "a part hangs on one node only, so it carries no force", FilterParameter::None, true,
     0.0, filters::make_articulation},
    {"small_angle", "two edges enclose less than this angle", FilterParameter::Angle, true, kFifteenDegrees,
     filters::make_small_angle},
    {"high_valence", "more than this many beams meet in a node", FilterParameter::Count, true, 6.0,
     filters::make_high_valence},
    {"short_edge", "an edge is shorter than this", FilterParameter::Length, false, 0.003,
     filters::make_short_edge},
    {"long_edge", "an edge is longer than this", FilterParameter::Length, false, 0.02,
     filters::make_long_edge},
    {"tight_clearance", "the gap between two beams that do not meet is smaller than this",
     FilterParameter::Length, false, 0.001, filters::make_tight_clearance},
    {"asymmetric", "the pattern is not its own mirror image", FilterParameter::None, false, 0.0,
     filters::make_asymmetric},
};

FilterChoice with_value(const FilterKind& kind, std::string_view text) {
    const std::string name(kind.name);
    switch (kind.parameter) {
        case FilterParameter::Angle:
            return {name, base::parse_angle(text)};
        case FilterParameter::Count:
            return {name, base::parse_number(text)};
        case FilterParameter::Length:
            return {name, base::parse_length(text)};
        case FilterParameter::None:
            break;
    }
    throw base::InputError("the filter " + name + " takes no value, and '" + std::string(text) +
                           "' was given");
}

/// The choice for each row of the catalogue; null without a choice.
std::vector<const FilterChoice*> choices_by_row(std::span<const FilterChoice> choices) {
    std::vector<const FilterChoice*> by_row(std::size(kCatalogue), nullptr);
    for (const FilterChoice& choice : choices) {
        const FilterChoice*& slot = by_row[&find_filter_kind(choice.name) - kCatalogue];
        if (slot != nullptr) throw base::InputError("the filter " + choice.name + " is chosen twice");
        slot = &choice;
    }
    return by_row;
}

Rule forbid(const NodeLayout& layout, std::span<const EdgeGroup> groups) {
    ConflictRule rule{std::vector<Pattern::Bits>(layout.candidate_edges().size()), "", "is forbidden"};
    for (const EdgeGroup& group : groups) {
        for (const EdgeIndex edge : Pattern(group.edges).edges()) rule.conflicts[edge].set(edge);
    }
    return rule;
}

void add_own(std::vector<Filter>& filters, const Filter& own) {
    if (std::ranges::find(filters, own.name, &Filter::name) != filters.end())
        throw base::InputError("there are two filters of the name '" + own.name + "'");
    filters.push_back(own);
}

std::optional<LayoutNodeIndex> parse_node(const NodeLayout& layout, std::string_view text) {
    if (text.starts_with('n')) text.remove_prefix(1);
    const int number = text.starts_with('+') ? -1 : base::read_number<int>(text).value_or(-1);
    if (number < 0 || number >= static_cast<int>(layout.nodes().size())) return std::nullopt;
    return LayoutNodeIndex(number);
}

}  // namespace

EdgeGroup parse_edge_group(const NodeLayout& layout, std::string_view text) {
    EdgeGroup group;
    if (text.find('-') != std::string_view::npos) {
        group.name = "edge " + std::string(text);
        group.edges.set(find_edge(layout, text));
        return group;
    }
    const std::optional<LayoutNodeIndex> node = parse_node(layout, text);
    if (!node)
        throw base::InputError("'" + std::string(text) +
                               "' is neither an edge, such as 0-1, nor a node, such as n5");
    group.name = "node n" + std::to_string(node->value);
    const LayoutNodeIndex in_fan = layout.left_partner(*node);
    for (std::size_t e = 0; e < layout.candidate_edges().size(); ++e) {
        const auto& [first, second] = layout.candidate_edges()[e];
        group.edges.set(e, layout.left_partner(first) == in_fan || layout.left_partner(second) == in_fan);
    }
    return group;
}

void FabricationScale::validate() const {
    if (!(tile_side > 0.0) || !std::isfinite(tile_side))
        throw base::InputError("the side of a tile is a positive length, and " +
                               base::format_number(tile_side) + " m was given");
    if (!(beam_width > 0.0) || !std::isfinite(beam_width))
        throw base::InputError("the width of a beam is a positive length, and " +
                               base::format_number(beam_width) + " m was given");
}

std::span<const FilterKind> filter_catalogue() {
    return kCatalogue;
}

const FilterKind& find_filter_kind(std::string_view name) {
    return base::find_named(name, kCatalogue, &FilterKind::name, "filter");
}

FilterChoice parse_filter_choice(std::string_view text) {
    const auto equals = text.find('=');
    const FilterKind& kind = find_filter_kind(text.substr(0, equals));
    if (equals == std::string_view::npos) return {std::string(kind.name), std::nullopt};
    return with_value(kind, text.substr(equals + 1));
}

std::vector<Filter> make_filters(const NodeLayout& layout, const FilterSettings& settings) {
    settings.scale.validate();
    const std::vector<const FilterChoice*> by_row = choices_by_row(settings.choices);
    std::vector<Filter> filters;
    for (std::size_t row = 0; row < std::size(kCatalogue); ++row) {
        const FilterKind& kind = kCatalogue[row];
        if (!kind.is_of_the_paper && by_row[row] == nullptr) continue;
        const double value =
            by_row[row] == nullptr ? kind.default_value : by_row[row]->value.value_or(kind.default_value);
        filters.push_back({std::string(kind.name), value, kind.make_rule(layout, value, settings.scale)});
    }
    if (!settings.required.empty())
        filters.push_back({"lacks_required", 0.0, CoverRule{settings.required, "the pattern lacks"}});
    if (!settings.forbidden.empty())
        filters.push_back({"has_forbidden", 0.0, forbid(layout, settings.forbidden)});
    for (const Filter& own : settings.own) add_own(filters, own);
    if (filters.size() > kMostFilters)
        throw base::InputError("there are " + std::to_string(filters.size()) + " filters, where at most " +
                               std::to_string(kMostFilters) + " are possible");
    return filters;
}

}  // namespace fretwork::pattern
