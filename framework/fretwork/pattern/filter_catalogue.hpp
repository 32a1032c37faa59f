// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/rule.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::pattern {

/// The lengths for rules in millimetres: the regular hexagon in which a fan would be made.
struct FabricationScale {
    double tile_side = 0.025980762113533160;  ///< m; 0.015 sqrt(3), the paper's hexagon
    double beam_width = 0.002;                ///< m; the paper's beams
    /// Throws InputError unless both are positive.
    void validate() const;
};

/// The kind of number that a filter is set with.
enum class FilterParameter { None, Angle, Count, Length };

/// A row of the catalogue: a reason for which patterns are rejected.
struct FilterKind {
    std::string_view name;      ///< what the command line calls it, and its column in the census
    std::string_view doc;       ///< one line: what it rejects
    FilterParameter parameter;  ///< radians, a whole number, or metres
    bool is_of_the_paper;       ///< always on, with its own column in the paper's Table 1
    double default_value;
    /// State the rule for a layout. `value` is the filter's number.
    Rule (*make_rule)(const NodeLayout& layout, double value, const FabricationScale& scale);
};

/// All filters, in the order of the census's columns: the paper's six first.
std::span<const FilterKind> filter_catalogue();

/// The filter of a name. Throws InputError that names the nearest one.
const FilterKind& find_filter_kind(std::string_view name);

/// A filter that is to be used, and its number; none: the catalogue's.
struct FilterChoice {
    std::string name;
    std::optional<double> value;  ///< radians, a whole number, or metres
};

/// Read "small_angle=20deg", "short_edge=3mm" or "asymmetric". Throws InputError.
FilterChoice parse_filter_choice(std::string_view text);

/// Read an edge ("0-1") or a node ("n5": all edges at this node of the fan). Throws InputError.
EdgeGroup parse_edge_group(const NodeLayout& layout, std::string_view text);

/// A filter that is ready for one layout.
struct Filter {
    std::string name;
    double value = 0.0;
    Rule rule;
};

/// The requirements on patterns.
struct FilterSettings {
    std::vector<FilterChoice> choices;  ///< values for the paper's six, and others that are switched on
    std::vector<EdgeGroup> required;    ///< of each, a pattern has at least one edge
    std::vector<EdgeGroup> forbidden;   ///< of these, a pattern has no edge
    FabricationScale scale;
    std::vector<Filter> own{};  ///< filters of the caller's for this layout; threads may call them at once
};

/// The paper's six filters, with the values chosen or the paper's, and any others that are chosen, in the
/// order of the catalogue; then "lacks_required" and "has_forbidden", if anything is, and the caller's own.
/// Throws InputError if a name is unknown or there twice, or its value is invalid.
std::vector<Filter> make_filters(const NodeLayout& layout, const FilterSettings& settings = {});

/// The verdict of one filter on a pattern.
Verdict judge(const NodeLayout& layout, const Filter& filter, const Pattern& pattern);
/// The verdict of the first filter that rejects a pattern.
Verdict judge(const NodeLayout& layout, std::span<const Filter> filters, const Pattern& pattern);

}  // namespace fretwork::pattern
