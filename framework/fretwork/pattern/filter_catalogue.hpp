// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/rule.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::pattern {

/// The sizes of the regular hexagon and of the beams to be made. Rules about lengths need them.
struct FabricationScale {
    double tile_side = 0.025980762113533160;  ///< side of the hexagon, m; 0.015 sqrt(3), as in the paper
    double beam_width = 0.002;                ///< width of the beams, m; as in the paper
    /// Throws InputError unless both lengths are positive and finite.
    void validate() const;
};

/// The kind of number that sets a filter.
enum class FilterParameter {
    None,   ///< the filter has no number
    Angle,  ///< an angle, rad
    Count,  ///< a whole number
    Length  ///< a length, m
};

/// A row of the catalogue: one reason to reject a pattern.
struct FilterKind {
    std::string_view name;      ///< name on the command line and of the column in the census
    std::string_view summary;   ///< one line that describes the rejected patterns
    FilterParameter parameter;  ///< kind of the filter's number: radians, a whole number, or metres
    bool is_of_the_paper;       ///< true for the six filters of the paper's Table 1, which are always on
    double default_value;       ///< the filter's number by default
    /// Make the filter's rule for a layout; `value` is the filter's number. Throws as make_filters().
    Rule (*make_rule)(const NodeLayout& layout, double value, const FabricationScale& scale);
};

/// All filters, in the order of the columns of the census: the paper's six first.
std::span<const FilterKind> filter_catalogue();

/// The filter with this name. Throws InputError that suggests the nearest name or, if none is near, lists
/// all names.
const FilterKind& find_filter_kind(std::string_view name);

/// The choice of a filter and its number.
struct FilterChoice {
    std::string name;  ///< name of a row of the catalogue
    /// The filter's number: radians, a whole number, or metres; none: the catalogue's default.
    std::optional<double> value;
};

/// Parse the choice of a filter: "small_angle=20deg", "short_edge=3mm" or "asymmetric". Throws InputError.
FilterChoice parse_filter_choice(std::string_view text);

/// Parse an edge ("0-1") or a node ("n5": all edges at this node of the fan). Throws InputError.
EdgeGroup parse_edge_group(const NodeLayout& layout, std::string_view text);

/// A filter with its rule for one layout.
struct Filter {
    std::string name;    ///< name of the column in the census
    double value = 0.0;  ///< the filter's number, SI
    Rule rule;           ///< the rule that patterns must keep
};

/// The requirements on patterns.
struct FilterSettings {
    std::vector<FilterChoice> choices;  ///< numbers for the paper's six filters, and further filters
    std::vector<EdgeGroup> required;    ///< a pattern has at least one edge of each group
    std::vector<EdgeGroup> forbidden;   ///< a pattern has no edge of any group
    FabricationScale scale;             ///< the sizes to which rules about lengths refer
    /// The caller's own filters for this layout; several threads may call a filter at once.
    std::vector<Filter> own{};
};

/// The filters for one layout. The list begins with the paper's six filters and the chosen further filters,
/// in the order of the catalogue. A filter without a chosen number takes the catalogue's default. The filters
/// "lacks_required" and "has_forbidden" follow, if edges are required or forbidden. The caller's own filters
/// are last. Throws InputError if a name is unknown or appears twice, a value is invalid, or there are more
/// than 64 filters. Throws NumericalError if an angle of the layout is so near to the limit of small_angle
/// that the two cannot be compared.
std::vector<Filter> make_filters(const NodeLayout& layout, const FilterSettings& settings = {});

/// The verdict of one filter on a pattern.
Verdict judge(const NodeLayout& layout, const Filter& filter, const Pattern& pattern);
/// The verdict of the first filter that rejects a pattern; an accepting verdict if no filter does.
Verdict judge(const NodeLayout& layout, std::span<const Filter> filters, const Pattern& pattern);

}  // namespace fretwork::pattern
