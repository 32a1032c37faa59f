// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/detail/conflicts.hpp>
#include <fretwork/pattern/detail/segment_distance.hpp>
#include <fretwork/pattern/filters/filters.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::pattern::filters {
namespace {

using detail::ConflictTable;
using detail::DistanceLimit;
using detail::place_candidates_in_hexagon;
using detail::PlacedEdge;

bool share_a_node(const PlacedEdge& left, const PlacedEdge& right) {
    return std::any_of(left.fan_nodes.begin(), left.fan_nodes.end(),
                       [&](int node) { return node == right.fan_nodes[0] || node == right.fan_nodes[1]; });
}

}  // namespace

// Two beams that do not meet in a node must leave a gap of at least `value` (m) between their flanks. The
// filter small_angle judges beams that meet in a node.
Rule make_tight_clearance(const NodeLayout& layout, double value, const FabricationScale& scale) {
    if (!(value >= 0.0) || !std::isfinite(value))
        throw base::InputError("a clearance is zero or more, and " + base::format_number(value) +
                               " m was given");
    const DistanceLimit limit((value + scale.beam_width) / scale.tile_side);
    const std::vector<PlacedEdge> placed = place_candidates_in_hexagon(layout);
    ConflictTable table(layout);
    for (std::size_t e = 0; e < layout.candidate_edges().size(); ++e) {
        for (std::size_t other = e + 1; other < placed.size(); ++other) {
            if (share_a_node(placed[e], placed[other])) continue;
            if (limit.exceeds_distance(placed[e], placed[other]))
                table.add(placed[e].edge, placed[other].edge);
        }
    }
    constexpr double kPerMetre = 1000.0;
    const std::string phrase =
        "leave less than " + base::format_number(value * kPerMetre) + " mm between them";
    return ConflictRule{table.take(), phrase, "and its copies " + phrase};
}

}  // namespace fretwork::pattern::filters
