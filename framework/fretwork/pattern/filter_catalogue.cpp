// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/detail/filters.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::pattern {
namespace {

constexpr double kFifteenDegrees = std::numbers::pi / 12;

// The paper's six come first, in the order of its Table 1.
constexpr FilterKind kCatalogue[] = {
    {"intersecting", "two edges cross", FilterParameter::None, 0.0, true, detail::make_intersecting},
    {"no_interface", "an interface node has no edge", FilterParameter::None, 0.0, true,
     detail::make_no_interface},
    {"multiple_components", "the fan falls apart", FilterParameter::None, 0.0, true,
     detail::make_multiple_components},
    {"articulation", "a part hangs on one node and bears nothing", FilterParameter::None, 0.0, true,
     detail::make_articulation},
    {"small_angle", "two edges enclose less than this angle", FilterParameter::Angle, kFifteenDegrees, true,
     detail::make_small_angle},
    {"high_valence", "more than this many beams meet in a node", FilterParameter::Count, 6.0, true,
     detail::make_high_valence},
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

/// The choice for each row of the catalogue, or none.
std::vector<const FilterChoice*> choices_by_row(std::span<const FilterChoice> choices) {
    std::vector<const FilterChoice*> by_row(std::size(kCatalogue), nullptr);
    for (const FilterChoice& choice : choices) {
        const FilterChoice*& slot =
            by_row[static_cast<std::size_t>(&find_filter_kind(choice.name) - kCatalogue)];
        if (slot != nullptr) throw base::InputError("the filter " + choice.name + " is chosen twice");
        slot = &choice;
    }
    return by_row;
}

}  // namespace

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
    std::vector<std::string> names;
    for (const FilterKind& kind : kCatalogue) {
        if (kind.name == name) return kind;
        names.emplace_back(kind.name);
    }
    throw base::InputError(base::unknown_name_message("filter", name, names));
}

FilterChoice parse_filter_choice(std::string_view text) {
    const auto equals = text.find('=');
    const FilterKind& kind = find_filter_kind(text.substr(0, equals));
    if (equals == std::string_view::npos) return {std::string(kind.name), std::nullopt};
    return with_value(kind, text.substr(equals + 1));
}

std::vector<Filter> make_filters(const NodeLayout& layout, std::span<const FilterChoice> choices,
                                 const FabricationScale& scale) {
    scale.validate();
    const std::vector<const FilterChoice*> by_row = choices_by_row(choices);
    std::vector<Filter> filters;
    for (std::size_t row = 0; row < std::size(kCatalogue); ++row) {
        const FilterKind& kind = kCatalogue[row];
        if (!kind.is_of_the_paper && by_row[row] == nullptr) continue;
        const double value =
            by_row[row] == nullptr ? kind.default_value : by_row[row]->value.value_or(kind.default_value);
        filters.push_back({&kind, value, kind.make_rule(layout, value, scale)});
    }
    return filters;
}

}  // namespace fretwork::pattern
