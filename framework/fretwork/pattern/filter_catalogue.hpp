// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/rule.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::pattern {

/// The size of the regular hexagon in which a fan would be made. Rules about lengths need it.
struct FabricationScale {
    double tile_side = 0.025980762113533160;  ///< m; 0.015 sqrt(3), the paper's hexagon
    double beam_width = 0.002;                ///< m; the paper's beams
    /// Throws InputError unless both are positive.
    void validate() const;
};

/// The kind of number that sets a filter.
enum class FilterParameter { None, Angle, Count, Length };

/// A row of the catalogue: one reason to reject a pattern.
struct FilterKind {
    std::string_view name;      ///< its name on the command line and its column in the census
    std::string_view doc;       ///< one line about the patterns that it rejects
    FilterParameter parameter;  ///< radians, a whole number, or metres
    bool is_of_the_paper;       ///< true for the six filters of the paper's Table 1, which are always on
    double default_value;       ///< where nothing is said
    /// State the rule for a layout. `value` is the filter's number.
    Rule (*make_rule)(const NodeLayout& layout, double value, const FabricationScale& scale);
};

/// All filters, in the order of the columns of the census: the paper's six first.
std::span<const FilterKind> filter_catalogue();

/// The filter with this name. Throws InputError that suggests the nearest name.
const FilterKind& find_filter_kind(std::string_view name);

/// A filter to be used, and its number.
struct FilterChoice {
    std::string name;             ///< a row of the catalogue
    std::optional<double> value;  ///< radians, a whole number, or metres; empty: the catalogue's default
};

/// Parse the choice of a filter: "small_angle=20deg", "short_edge=3mm" or "asymmetric". Throws InputError.
FilterChoice parse_filter_choice(std::string_view text);

/// Parse an edge ("0-1") or a node ("n5": all edges at this node of the fan). Throws InputError.
EdgeGroup parse_edge_group(const NodeLayout& layout, std::string_view text);

/// A filter with its rule for one layout.
struct Filter {
    std::string name;    ///< the word for its census column
    double value = 0.0;  ///< its limit, SI
    Rule rule;           ///< what it demands
};

/// The requirements on patterns.
struct FilterSettings {
    std::vector<FilterChoice> choices;  ///< values for the paper's six filters, and other filters to be
                                        ///< switched on
    std::vector<EdgeGroup> required;    ///< a pattern has at least one edge of each group
    std::vector<EdgeGroup> forbidden;   ///< a pattern has no edge of any of these groups
    FabricationScale scale;             ///< what lengths refer to
    std::vector<Filter> own{};  ///< the caller's own filters for this layout; several threads may call them
                                ///< at once
};

/// The filters for one layout. First come the paper's six and any others chosen, in the order of the
/// catalogue. A filter without a chosen value takes the catalogue's default. Then come "lacks_required" and
/// "has_forbidden", if edges are required or forbidden, and last the caller's own. Throws InputError if a
/// name is unknown or appears twice, or a value is invalid.
std::vector<Filter> make_filters(const NodeLayout& layout, const FilterSettings& settings = {});

/// The verdict of one filter on a pattern.
Verdict judge(const NodeLayout& layout, const Filter& filter, const Pattern& pattern);
/// The verdict of the first filter that rejects a pattern.
Verdict judge(const NodeLayout& layout, std::span<const Filter> filters, const Pattern& pattern);

}  // namespace fretwork::pattern
