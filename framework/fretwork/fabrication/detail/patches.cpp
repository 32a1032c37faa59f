// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/fabrication/detail/patches.hpp>
#include <fretwork/geometry/plane.hpp>

#include <map>
#include <numbers>
#include <string>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Point2;

constexpr double kFullTurn = 2.0 * std::numbers::pi;
/// Bars that go straight on need no round end.
constexpr double kStraightOn = 1e-6;  // rad

Patch patch(geometry::Polygon polygon, std::optional<Disc> disc = std::nullopt) {
    Patch made{std::move(polygon), disc, {}};
    made.box = box_of(made.polygon);
    return made;
}

Patch rectangle(const Point2& from, const Point2& to, double width) {
    const Point2 aside = 0.5 * width * left_of(unit(to - from));
    return patch({from - aside, to - aside, to + aside, from + aside});
}

/// A disc around a node, with corners where the arc from `from` to `to` begins and ends. It is the whole
/// disc and not only the arc's sector, so that it overlaps the bars instead of only touching them.
Patch round_end(const Disc& disc, double from, double to) {
    geometry::Polygon polygon;
    const auto add_arc = [&](double start, double end) {
        const int chords = std::max(1, static_cast<int>(std::ceil((end - start) / kChordAngle)));
        for (int i = 0; i < chords; ++i)
            polygon.push_back(disc.center +
                              disc.radius * geometry::direction(start + (end - start) * i / chords));
    };
    add_arc(from, to);
    add_arc(to, from + kFullTurn);
    return patch(std::move(polygon), disc);
}

/// For each node and width, the angles of the bars that leave the node.
using Directions = std::map<std::pair<int, double>, std::vector<double>>;  // by node and width

Directions directions(const BarPlan& plan) {
    Directions found;
    for (const Bar& bar : plan.bars) {
        const Point2& from = plan.nodes[bar.nodes[0]];
        const Point2& to = plan.nodes[bar.nodes[1]];
        const Point2 along = to - from;
        found[{bar.nodes[0], bar.width}].push_back(std::atan2(along.y, along.x));
        found[{bar.nodes[1], bar.width}].push_back(std::atan2(-along.y, -along.x));
    }
    for (auto& [place, angles] : found) std::sort(angles.begin(), angles.end());
    return found;
}

/// Add the round ends that the rectangles at a node do not cover.
void add_round_ends(std::vector<Patch>& patches, const Disc& disc, const std::vector<double>& angles) {
    constexpr double kQuarter = std::numbers::pi / 2.0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double next = i + 1 < angles.size() ? angles[i + 1] : angles.front() + kFullTurn;
        if (next - angles[i] <= std::numbers::pi + kStraightOn) continue;
        patches.push_back(round_end(disc, angles[i] + kQuarter, next - kQuarter));
    }
}

}  // namespace

std::vector<Patch> bar_patches(const BarPlan& plan, double growth) {
    std::vector<Patch> patches;
    for (const Bar& bar : plan.bars)
        patches.push_back(rectangle(plan.nodes[bar.nodes[0]], plan.nodes[bar.nodes[1]], bar.width + growth));
    for (const auto& [place, angles] : directions(plan)) {
        const auto& [node, width] = place;
        add_round_ends(patches, {plan.nodes[node], 0.5 * (width + growth)}, angles);
    }
    return patches;
}

Patch disc_patch(const Disc& disc) {
    return round_end(disc, 0.0, std::numbers::pi);
}

std::vector<Disc> near_discs(const geometry::Polygon& polygon, const std::vector<Disc>& discs) {
    std::vector<Disc> near;
    const Box box = geometry::box_of(std::span<const Point2>(polygon));
    for (const Disc& disc : discs) {
        const Point2& c = disc.center;
        if (geometry::grown({c.x, c.y, c.x, c.y}, disc.radius).meets(box)) near.push_back(disc);
    }
    return near;
}

std::set<TessellationNodeIndex> nodes_with_bars(const BarPlan& plan) {
    std::set<TessellationNodeIndex> nodes;
    for (const Bar& bar : plan.bars) nodes.insert(bar.nodes.begin(), bar.nodes.end());
    for (const BarPlan::Coincidence& one : plan.coincidences)
        if (nodes.contains(one.taken)) nodes.insert(one.node);
    return nodes;
}

void require_bars_at_bolts(const BarPlan& plan, std::span<const TessellationNodeIndex> bolts) {
    const auto nodes = nodes_with_bars(plan);
    for (const TessellationNodeIndex node : bolts) {
        if (nodes.contains(node)) continue;
        const bool is_there = node.is_valid() && static_cast<std::size_t>(node) < plan.nodes.size();
        throw base::InputError("the hole for a bolt at node " + std::to_string(node) +
                               (is_there ? ", " + place_text(plan.nodes[node]) + "," : "") +
                               " is where no bar ends; a node with a bar is needed");
    }
}

}  // namespace fretwork::fabrication::detail
