// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/hexagon.hpp>
#include <fretwork/pattern/detail/quotient.hpp>
#include <fretwork/pattern/fan.hpp>

namespace fretwork::pattern::detail {
namespace {

/// The number of a node of the fan, by orbit and then by sector; all copies of the center are one node.
int fan_node_number(const Quotient::Place& place, int sector, const Quotient& quotient) {
    const bool is_center = place.orbit == quotient.center();
    return place.orbit * kReferenceSides + (is_center ? 0 : (sector + place.shift) % kReferenceSides);
}

}  // namespace

std::vector<PlacedEdge> place_candidates_in_hexagon(const NodeLayout& layout) {
    const Quotient quotient(layout);
    std::vector<ExactPoint> points;
    for (const LayoutNode& node : layout.nodes()) points.push_back(exact_point(node));
    std::vector<PlacedEdge> placed;
    for (int t = 0; t < kReferenceSides; ++t) {
        for (std::size_t e = 0; e < layout.candidate_edges().size(); ++e) {
            const auto& [first, second] = layout.candidate_edges()[e];
            placed.push_back({EdgeIndex(e),
                              t,
                              {fan_node_number(quotient.place(first), t, quotient),
                               fan_node_number(quotient.place(second), t, quotient)},
                              {points[first], points[second]}});
        }
        for (ExactPoint& point : points) point = next_sector(point);
    }
    return placed;
}

}  // namespace fretwork::pattern::detail
