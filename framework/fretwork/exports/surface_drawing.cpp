// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/detail/svg_canvas.hpp>
#include <fretwork/exports/surface_drawing.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fretwork::exports {
namespace {

using detail::SvgCanvas;
using mechanics::Dof;
using pattern::Point2;
using simulation::Conditions;
using simulation::Surface;

constexpr const char* kBeamColour = "#22303c";
constexpr const char* kLoadColour = "#20419a";

double mean_side(const Surface& surface) {
    double sum = 0.0;
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        sum += pattern::mean_side(tiling::tile_polygon(surface.tessellation, tiling::TileIndex(t)));
    }
    return sum / static_cast<double>(surface.tessellation.tiles.size());
}

/// The width of a beam as seen from above: that of a square of the section's area.
double beam_width(const Surface& surface) {
    return std::sqrt(surface.setting.section.area);
}

void draw_tiles(SvgCanvas& canvas, const Surface& surface) {
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        const auto polygon = tiling::tile_polygon(surface.tessellation, tiling::TileIndex(t));
        canvas.polygon(polygon, {pattern_colour(surface.tessellation.tiles[t].pattern), "#ffffff",
                                 0.2 * beam_width(surface), 1.0});
    }
}

void draw_beams(SvgCanvas& canvas, const Surface& surface) {
    std::vector<std::array<Point2, 2>> beams;
    for (const auto& edge : surface.fan.edges) {
        beams.push_back({surface.fan.nodes[static_cast<std::size_t>(edge.nodes[0])],
                         surface.fan.nodes[static_cast<std::size_t>(edge.nodes[1])]});
    }
    canvas.segments(beams, {"none", kBeamColour, beam_width(surface), 1.0});
}

detail::Colour support_colour(const mechanics::DofSet& fixed) {
    if (fixed == mechanics::DofSet::all()) return "#d7301f";
    if (fixed == mechanics::DofSet::translations()) return "#1a9850";
    return "#f28e2b";
}

/// Forces in the plane are arrows that end at the node; forces out of it a ring, with a dot if they come up
/// to the viewer.
void draw_load(SvgCanvas& canvas, const Point2& node, const Eigen::Vector3d& force, double length) {
    const double across = force.head<2>().norm();
    const double size = length * force.norm();
    if (across >= 0.2 * force.norm() && across > 0) {
        const Point2 tail{node.x - length * force.x(), node.y - length * force.y()};
        canvas.arrow(tail, node, 0.35 * size, {"none", kLoadColour, 0.08 * size, 1.0});
        return;
    }
    const double radius = 0.3 * size;
    canvas.circle(node, radius, {"#ffffff", kLoadColour, 0.25 * radius, 1.0});
    if (force.z() > 0) {
        canvas.circle(node, 0.35 * radius, {kLoadColour, "none", 0.0, 1.0});
    } else {
        const double arm = 0.7 * radius;
        const std::array<std::array<Point2, 2>, 2> cross = {
            {{{{node.x - arm, node.y - arm}, {node.x + arm, node.y + arm}}},
             {{{node.x - arm, node.y + arm}, {node.x + arm, node.y - arm}}}}};
        canvas.segments(cross, {"none", kLoadColour, 0.25 * radius, 1.0});
    }
}

void draw_conditions(SvgCanvas& canvas, const Surface& surface, const Conditions& conditions) {
    const auto place = [&](mechanics::NodeIndex node) {
        return surface.tessellation.interface_nodes[static_cast<std::size_t>(node)];
    };
    const double side = mean_side(surface);
    for (const mechanics::Support& support : conditions.supports) {
        canvas.circle(place(support.node), 0.16 * side,
                      {support_colour(support.fixed), "#ffffff", 0.03 * side, 1.0});
    }
    double largest = 0.0;
    for (const mechanics::NodalLoad& load : conditions.loads) largest = std::max(largest, load.force.norm());
    for (const mechanics::NodalLoad& load : conditions.loads) {
        if (load.force.norm() > 0) draw_load(canvas, place(load.node), load.force, 1.2 * side / largest);
    }
}

}  // namespace

std::string surface_svg(const Surface& surface, const Conditions* conditions) {
    SvgCanvas canvas(detail::bounding_box(surface.tessellation.vertices, 0.8 * mean_side(surface)), 1.0);
    draw_tiles(canvas, surface);
    draw_beams(canvas, surface);
    if (conditions != nullptr) draw_conditions(canvas, surface, *conditions);
    return canvas.document("Tessellation with " + std::to_string(surface.tessellation.tiles.size()) +
                           " tiles and " + std::to_string(surface.tessellation.patterns.size()) +
                           " patterns");
}

}  // namespace fretwork::exports
