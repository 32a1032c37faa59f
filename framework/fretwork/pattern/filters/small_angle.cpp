// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/detail/angle_limit.hpp>
#include <fretwork/pattern/detail/conflicts.hpp>
#include <fretwork/pattern/detail/hexagon.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/pattern/filters/filters.hpp>

#include <cmath>
#include <map>
#include <numbers>

namespace fretwork::pattern::filters {
namespace {

using detail::AngleLimit;
using detail::ConflictTable;
using detail::ExactVector;
using detail::place_candidates_in_hexagon;
using detail::PlacedEdge;

/// A beam as it leaves a node of the fan.
struct Departure {
    EdgeIndex edge;
    ExactVector direction;
};

/// Every departure at one node of each orbit; all other departures are rotations of these.
std::map<int, std::vector<Departure>> departures_by_node(const NodeLayout& layout) {
    std::map<int, std::vector<Departure>> departures;
    for (const PlacedEdge& placed : place_candidates_in_hexagon(layout)) {
        for (std::size_t end = 0; end < 2; ++end) {
            const int node = placed.fan_nodes[end];
            if (node % kReferenceSides != 0) continue;
            departures[node].push_back({placed.edge, placed.points[1 - end] - placed.points[end]});
        }
    }
    return departures;
}

/// The angle in degrees, rounded, because 15 degrees return from radians as 14.999999999999998.
std::string degrees_text(double radians) {
    constexpr double kDigits = 1e9;
    return base::format_number(std::round(radians * 180.0 / std::numbers::pi * kDigits) / kDigits);
}

}  // namespace

// Paper, Section 4.2, "Fabrication constraints". Two beams that meet in a node of the fan may come from two
// sectors. They may also be two rotated copies of one edge.
Rule make_small_angle(const NodeLayout& layout, double value, const FabricationScale&) {
    const AngleLimit limit(value);
    ConflictTable table(layout);
    for (const auto& [node, departures] : departures_by_node(layout)) {
        for (std::size_t i = 0; i < departures.size(); ++i) {
            for (std::size_t j = i + 1; j < departures.size(); ++j) {
                if (limit.exceeds_angle(departures[i].direction, departures[j].direction))
                    table.add(departures[i].edge, departures[j].edge);
            }
        }
    }
    const std::string phrase = "enclose less than " + degrees_text(value) + " degrees";
    return ConflictRule{table.take(), phrase, "and its neighbour copies " + phrase};
}

}  // namespace fretwork::pattern::filters
