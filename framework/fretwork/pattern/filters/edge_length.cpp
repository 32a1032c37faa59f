// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/detail/hexagon.hpp>
#include <fretwork/pattern/filters/filters.hpp>

#include <cmath>

namespace fretwork::pattern::filters {
namespace {

using detail::exact_point;
using detail::ExactNumber;
using detail::ExactVector;
using detail::hexagon_dot;

/// Forbid every edge with a wrong length in a hexagon with side `tile_side`.
template <class IsWrong>
ConflictRule forbid_by_length(const NodeLayout& layout, const FabricationScale& scale,
                              const IsWrong& is_wrong) {
    const ExactNumber side(scale.tile_side);
    ConflictRule rule{std::vector<Pattern::Bits>(layout.candidate_edges().size()), "", ""};
    for (std::size_t e = 0; e < layout.candidate_edges().size(); ++e) {
        const auto& [first, second] = layout.candidate_edges()[e];
        const ExactVector along = exact_point(layout.nodes()[second]) - exact_point(layout.nodes()[first]);
        const ExactNumber square = hexagon_dot(along, along) * side * side;
        rule.conflicts[e].set(e, is_wrong(square));
    }
    return rule;
}

ExactNumber checked_square(double length) {
    if (!(length >= 0.0) || !std::isfinite(length))
        throw base::InputError("a limit of length is zero or more, and " + base::format_number(length) +
                               " m was given");
    return ExactNumber(length) * ExactNumber(length);
}

std::string millimetres(double length) {
    constexpr double kPerMetre = 1000.0;
    return base::format_number(length * kPerMetre) + " mm";
}

}  // namespace

Rule make_short_edge(const NodeLayout& layout, double value, const FabricationScale& scale) {
    const ExactNumber limit = checked_square(value);
    ConflictRule rule =
        forbid_by_length(layout, scale, [&](const ExactNumber& square) { return square < limit; });
    rule.self_phrase = "is shorter than " + millimetres(value);
    return rule;
}

Rule make_long_edge(const NodeLayout& layout, double value, const FabricationScale& scale) {
    const ExactNumber limit = checked_square(value);
    ConflictRule rule =
        forbid_by_length(layout, scale, [&](const ExactNumber& square) { return square > limit; });
    rule.self_phrase = "is longer than " + millimetres(value);
    return rule;
}

}  // namespace fretwork::pattern::filters
