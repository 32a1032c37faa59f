// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/surface_parts.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/mechanics/frame/section.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace fretwork::exports::detail {
namespace {

using geometry::Point2;
using simulation::Conditions;
using simulation::Surface;

constexpr const char* kForceColour = "#20419a";
constexpr const char* kMomentColour = "#7b3294";
constexpr const char* kPrescribedColour = "#b2451f";
constexpr const char* kPaleFace = "#eef1f4";
constexpr const char* kPaleBeam = "#98a2ac";

/// The place of an interface node. These nodes are the first ones of every model.
Point2 node_place(const Surface& surface, mechanics::NodeIndex node) {
    return surface.tessellation.interface_nodes[tiling::InterfaceIndex(node.value)];
}

/// Where the arrow of a load starts.
Eigen::Vector3d tail_of(LoadMark::Kind kind, const Eigen::Vector3d& node, const Eigen::Vector3d& arrow) {
    if (kind == LoadMark::Kind::Moment) return node - 0.5 * arrow;
    return arrow.z() > 0.2 * arrow.norm() ? node : Eigen::Vector3d(node - arrow);
}

LoadMark load_mark(LoadMark::Kind kind, const Point2& place, const Eigen::Vector3d& arrow,
                   const Projection& projection) {
    const Eigen::Vector3d node(place.x, place.y, 0.0);
    const Eigen::Vector3d tail = tail_of(kind, node, arrow);
    LoadMark mark{kind, LoadMark::Shape::Arrow, projection(tail), projection(Eigen::Vector3d(tail + arrow)),
                  arrow.norm()};
    const double seen = geometry::distance(mark.from, mark.to);
    if (seen < 0.2 * arrow.norm()) {
        mark.shape = projection.nearness(arrow) > 0.0 ? LoadMark::Shape::TowardsViewer
                                                      : LoadMark::Shape::AwayFromViewer;
        mark.from = mark.to = projection(node);
    }
    return mark;
}

void draw_ring(SvgCanvas& canvas, const LoadMark& mark, const Colour& colour) {
    const double radius = 0.14 * mark.size;
    const Style line{"none", colour, 0.22 * radius, 1.0};
    canvas.circle(mark.from, radius, {"#ffffff", colour, line.stroke_width, 1.0});
    if (mark.shape == LoadMark::Shape::TowardsViewer) {
        canvas.circle(mark.from, 0.35 * radius, {colour, "none", 0.0, 1.0});
        return;
    }
    const double arm = 0.6 * radius;
    const Point2& c = mark.from;
    const std::array<std::array<Point2, 2>, 2> cross = {
        {{Point2{c.x - arm, c.y - arm}, Point2{c.x + arm, c.y + arm}},
         {Point2{c.x - arm, c.y + arm}, Point2{c.x + arm, c.y - arm}}}};
    canvas.segments(cross, line);
}

/// Draw a pale plate for a text over bars.
void draw_ground(SvgCanvas& canvas, const Point2& corner, const Point2& size) {
    const std::array<Point2, 4> corners = {{corner,
                                            {corner.x + size.x, corner.y},
                                            {corner.x + size.x, corner.y + size.y},
                                            {corner.x, corner.y + size.y}}};
    canvas.polygon(corners, {"#ffffff", "none", 0.0, 0.8});
}

}  // namespace

double beam_width(const Surface& surface) {
    return mechanics::section_width(surface.setting.section);
}

void draw_tiles(SvgCanvas& canvas, const Surface& surface, const Projection& projection, Tint tint) {
    canvas.layer("tiles");
    const tiling::Tessellation& tessellation = surface.tessellation;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        const auto polygon = projection.all(tiling::tile_polygon(tessellation, tiling::TileIndex(t)));
        const int pattern = tessellation.tiles[t].pattern;
        const std::string number = std::to_string(t);
        const std::string id = pattern < 0 ? "not painted" : tessellation.patterns[pattern].id;
        const Style style = pattern < 0 ? Style{"#f4f6f8", "#8fa3b5", 0.2 * beam_width(surface), 1.0}
                                        : Style{tint == Tint::Pale ? kPaleFace : pattern_colour(pattern),
                                                "#ffffff", 0.2 * beam_width(surface), 1.0};
        canvas.named_polygon(polygon, style, "tile" + number, "tile " + number + ": " + id);
    }
}

void draw_labels(SvgCanvas& canvas, const Surface& surface, const DrawnLabels& labels) {
    using Shown = DrawnLabels::Shown;
    const double height = 0.3 * tiling::mean_tile_side(surface.tessellation);
    if (labels.interface_nodes == Shown::Yes) {
        canvas.layer("numbers of interface nodes");
        const auto& nodes = surface.tessellation.interface_nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            canvas.circle(nodes[i], 0.12 * height, {"#1b9e77", "none", 0.0, 1.0});
            const std::string number = std::to_string(i);
            const Point2 start{nodes[i].x + 0.2 * height, nodes[i].y + 0.1 * height};
            const double size = 0.6 * height;
            draw_ground(canvas, {start.x, start.y - 0.15 * size}, {text_width(number, size), size});
            canvas.text(start, number, size);
        }
    }
    if (labels.tiles == Shown::No) return;
    canvas.layer("numbers of tiles");
    const auto centers = tiling::tile_centers(surface.tessellation);
    for (std::size_t t = 0; t < centers.size(); ++t) {
        canvas.circle(centers[t], 0.75 * height, {"#ffffff", "none", 0.0, 0.8});
        canvas.text({centers[t].x, centers[t].y - 0.35 * height}, std::to_string(t), height, Anchor::Middle);
    }
}

void draw_beams(SvgCanvas& canvas, const Surface& surface, const Projection& projection, Tint tint) {
    canvas.layer("beams");
    const simulation::SurfaceBeams drawn = simulation::surface_beams(surface);
    std::vector<Point2> places;
    for (const Eigen::Vector3d& node : drawn.nodes) places.push_back({node.x(), node.y()});
    const std::vector<Point2> nodes = projection.all(places);
    std::vector<Segments> beams(surface.tessellation.tiles.size());
    for (std::size_t b = 0; b < drawn.ends.size(); ++b) {
        const auto& ends = drawn.ends[b];
        beams[drawn.tiles[b]].push_back({nodes[ends[0]], nodes[ends[1]]});
    }
    const Style style{"none", tint == Tint::Pale ? kPaleBeam : kBeamColour, beam_width(surface), 1.0};
    for (std::size_t t = 0; t < beams.size(); ++t)
        canvas.named_segments(beams[t], style, "beams" + std::to_string(t));
}

std::vector<mechanics::Support> supports_of_nodes(const Conditions& conditions) {
    std::map<mechanics::NodeIndex, mechanics::DofSet> held;
    for (const mechanics::Support& support : conditions.supports) held[support.node] |= support.fixed;
    std::vector<mechanics::Support> supports;
    for (const auto& [node, fixed] : held) supports.push_back({node, fixed});
    return supports;
}

std::vector<SupportMark> support_marks(const Surface& surface, const Conditions& conditions,
                                       const Projection& projection) {
    std::vector<SupportMark> marks;
    for (const mechanics::Support& support : supports_of_nodes(conditions)) {
        const Point2 place = projection(node_place(surface, support.node));
        if (support.fixed == mechanics::DofSet::all()) {
            marks.push_back({place, "#d7301f", "all components held"});
        } else if (support.fixed == mechanics::DofSet::translations()) {
            marks.push_back({place, "#1a9850", "displacements held"});
        } else {
            marks.push_back({place, "#f28e2b", "some components held"});
        }
    }
    return marks;
}

std::vector<Point2> prescribed_marks(const Surface& surface, const Conditions& conditions,
                                     const Projection& projection) {
    std::set<mechanics::NodeIndex> nodes;
    for (const mechanics::PrescribedDisplacement& entry : conditions.prescribed) nodes.insert(entry.node);
    std::vector<Point2> places;
    for (const mechanics::NodeIndex node : nodes) places.push_back(projection(node_place(surface, node)));
    return places;
}

std::vector<mechanics::NodalLoad> loads_of_nodes(const Conditions& conditions) {
    std::map<mechanics::NodeIndex, mechanics::NodalLoad> sums;
    for (const mechanics::NodalLoad& load : conditions.loads) {
        mechanics::NodalLoad& sum =
            sums.try_emplace(load.node, mechanics::NodalLoad{load.node}).first->second;
        sum.force += load.force;
        sum.moment += load.moment;
    }
    std::vector<mechanics::NodalLoad> loads;
    for (const auto& [node, sum] : sums) loads.push_back(sum);
    return loads;
}

std::vector<LoadMark> load_marks(const Surface& surface, const Conditions& conditions,
                                 const Projection& projection, double reach) {
    using Kind = LoadMark::Kind;
    double largest_force = 0.0;
    double largest_moment = 0.0;
    const std::vector<mechanics::NodalLoad> loads = loads_of_nodes(conditions);
    for (const mechanics::NodalLoad& load : loads) {
        largest_force = std::max(largest_force, load.force.norm());
        largest_moment = std::max(largest_moment, load.moment.norm());
    }
    std::vector<LoadMark> marks;
    for (const mechanics::NodalLoad& load : loads) {
        const Point2 place = node_place(surface, load.node);
        if (load.force.norm() > 0.0)
            marks.push_back(load_mark(Kind::Force, place, load.force * (reach / largest_force), projection));
        if (load.moment.norm() > 0.0)
            marks.push_back(
                load_mark(Kind::Moment, place, load.moment * (reach / largest_moment), projection));
    }
    return marks;
}

void draw_support(SvgCanvas& canvas, const SupportMark& mark, double radius) {
    canvas.ball(mark.place, radius, mark.colour);
}

void draw_prescribed(SvgCanvas& canvas, const Point2& place, double radius) {
    const std::array<Point2, 4> corners = {{{place.x, place.y - radius},
                                            {place.x + radius, place.y},
                                            {place.x, place.y + radius},
                                            {place.x - radius, place.y}}};
    canvas.polygon(corners, {kPrescribedColour, "#ffffff", 0.15 * radius, 1.0});
}

void draw_load(SvgCanvas& canvas, const LoadMark& mark) {
    const bool is_force = mark.kind == LoadMark::Kind::Force;
    const Colour colour = is_force ? kForceColour : kMomentColour;
    if (mark.shape != LoadMark::Shape::Arrow) return draw_ring(canvas, mark, colour);
    const double head = 0.26 * mark.size;
    const Style style{"none", colour, 0.05 * mark.size, 1.0};
    canvas.arrow(mark.from, mark.to, head, style);
    if (is_force) return;
    // A moment has a second head behind the first.
    const double back = 0.75 * head / std::max(geometry::distance(mark.from, mark.to), head);
    canvas.arrow(mark.from,
                 {mark.to.x + back * (mark.from.x - mark.to.x), mark.to.y + back * (mark.from.y - mark.to.y)},
                 head, style);
}

}  // namespace fretwork::exports::detail
