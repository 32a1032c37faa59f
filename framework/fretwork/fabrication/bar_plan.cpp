// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/bar_plan.hpp>
#include <fretwork/fabrication/detail/bar_angles.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace fretwork::fabrication {
namespace {

using geometry::Point2;

using namespace detail;

/// Nodes nearer than this are one node.
constexpr double kSamePlace = 1e-8;  // m

/// For each point, the index of the first point at its place.
std::vector<std::size_t> first_at_place(const std::vector<Point2>& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(points[a].x, a) < std::pair(points[b].x, b);
    });
    std::vector<std::size_t> first(points.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Point2& a = points[order[i]];
            const Point2& b = points[order[j]];
            if (b.x - a.x > kSamePlace) break;
            if (std::abs(b.y - a.y) > kSamePlace) continue;
            first[std::max(order[i], order[j])] = std::min(first[order[i]], first[order[j]]);
        }
    }
    return first;
}

/// Let bars end at the first node of each place.
void join_coincident_nodes(BarPlan& plan) {
    const auto first = first_at_place(plan.nodes);
    for (std::size_t n = 0; n < first.size(); ++n) {
        if (first[n] != n)
            plan.coincidences.push_back({TessellationNodeIndex(n), TessellationNodeIndex(first[n])});
    }
    for (Bar& bar : plan.bars) {
        for (TessellationNodeIndex& node : bar.nodes) node = TessellationNodeIndex(first[node]);
        if (bar.nodes[0] == bar.nodes[1])
            throw base::GeometryError("tile " + std::to_string(bar.tile) + " has a beam without length at " +
                                      place_text(plan.nodes[bar.nodes[0]]));
    }
}

/// Add bars along every side of the rim, from its vertex over its interface nodes to its next vertex.
void add_frame(BarPlan& plan, const tiling::Tessellation& tessellation, double width) {
    const std::size_t first_vertex = plan.nodes.size();
    plan.nodes.insert(plan.nodes.end(), tessellation.vertices.begin(), tessellation.vertices.end());
    std::vector<tiling::RimSide> sides;
    for (const auto& line : tiling::rim_sides(tessellation))
        sides.insert(sides.end(), line.begin(), line.end());
    std::ranges::sort(sides, {}, [](const tiling::RimSide& side) { return std::pair(side.from, side.to); });
    for (const tiling::RimSide& side : sides) {
        TessellationNodeIndex here(first_vertex + side.from);
        const auto go_to = [&](TessellationNodeIndex next) {
            plan.bars.push_back({{here, next}, width, side.tile});
            here = next;
        };
        for (const tiling::InterfaceIndex node : side.nodes) go_to(TessellationNodeIndex(node.value));
        go_to(TessellationNodeIndex(first_vertex + side.to));
    }
}

void require_closed_tiles(const simulation::Surface& surface) {
    tiling::validate(surface.tessellation, surface.layout);
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        if (surface.tessellation.tiles[t].pattern < 0)
            throw base::InputError("tile " + std::to_string(t) +
                                   " is not painted: it has no beams that could be made");
    }
}

double positive_side(double square, const char* what) {
    const double side = std::sqrt(square);
    if (std::isfinite(side) && side > 0.0) return side;
    throw base::InputError("the setting's beams have no " + std::string(what) +
                           ": area and second moments of their section must be above zero");
}

}  // namespace

Rectangle equivalent_rectangle(const mechanics::Section& section) {
    return {positive_side(12.0 * section.I3 / section.area, "width"),
            positive_side(12.0 * section.I2 / section.area, "height")};
}

BarPlan bar_plan(const simulation::Surface& surface, double frame_width) {
    if (!(frame_width >= 0.0) || !std::isfinite(frame_width))
        throw base::InputError("the width of a frame is " + base::format_number(frame_width) +
                               " m, where zero (no frame) or a length is needed");
    require_closed_tiles(surface);
    const Rectangle bar = equivalent_rectangle(surface.setting.section);
    const tiling::TessellationFan fan = simulation::surface_fan(surface);
    BarPlan plan{.nodes = fan.nodes,
                 .width = bar.width,
                 .height = bar.height,
                 .interface_nodes = static_cast<std::size_t>(fan.interface_node_count)};
    for (const tiling::TessellationFan::Edge& edge : fan.edges)
        plan.bars.push_back({edge.nodes, bar.width, edge.tile});
    if (frame_width > 0.0) add_frame(plan, surface.tessellation, frame_width);
    join_coincident_nodes(plan);
    if (plan.bars.empty()) throw base::InputError("the surface has no beams that could be made");
    require_no_crossings(plan);
    return plan;
}

}  // namespace fretwork::fabrication
