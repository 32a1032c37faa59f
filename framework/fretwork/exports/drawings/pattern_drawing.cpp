// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/drawings/detail/fan_drawing.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/print.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace fretwork::exports {
namespace {

using detail::Anchor;
using detail::kInterfaceColour;
using detail::SvgCanvas;
using geometry::Point2;
using pattern::NodeLayout;
using pattern::Pattern;

constexpr const char* kEdgeColour = "#8fa3b5";

Point2 at(const pattern::LayoutNode& node, const std::array<Point2, 3>& triangle) {
    Point2 place;
    for (std::size_t k = 0; k < 3; ++k) {
        place.x += node.place[k].to_double() * triangle[k].x;
        place.y += node.place[k].to_double() * triangle[k].y;
    }
    return place;
}

/// The base triangle with all nodes of the layout, numbered in text of this height, and all candidate edges.
void draw_base_triangle(SvgCanvas& canvas, const NodeLayout& layout, const std::array<Point2, 3>& triangle,
                        double text) {
    const double size = geometry::distance(triangle[1], triangle[2]);
    canvas.polygon(triangle, {"#f4f6f8", detail::kRimColour, 0.008 * size, 1.0});
    detail::Segments edges;
    for (const pattern::Edge& edge : layout.candidate_edges()) {
        edges.push_back(
            {at(layout.nodes()[edge.first], triangle), at(layout.nodes()[edge.second], triangle)});
    }
    canvas.segments(edges, {"none", kEdgeColour, 0.006 * size, 1.0});
    for (std::size_t i = 0; i < layout.nodes().size(); ++i) {
        const pattern::LayoutNode& node = layout.nodes()[i];
        const bool is_interface = node.region == pattern::Region::Interface;
        const Point2 place = at(node, triangle);
        canvas.circle(place, 0.03 * size,
                      {is_interface ? kInterfaceColour : "#ffffff", detail::kBeamColour, 0.008 * size, 1.0});
        canvas.text({place.x + 0.05 * size, place.y + 0.035 * size}, std::to_string(i),
                    std::max(0.07 * size, text));
    }
}

/// The base triangle with all candidate edges, around the origin and as large as a fan.
void draw_layout(SvgCanvas& canvas, const NodeLayout& layout, double side, double text) {
    const std::array<Point2, 3> triangle = {Point2{0.0, 0.8 * side}, Point2{-0.92 * side, -0.8 * side},
                                            Point2{0.92 * side, -0.8 * side}};
    draw_base_triangle(canvas, layout, triangle, text);
    canvas.text({0.0, -side - text}, layout.name(), text, Anchor::Middle);
}

/// The ids of patterns, in lines that fit below their fans.
std::vector<std::vector<std::string>> id_lines(const NodeLayout& layout, std::span<const Pattern> patterns,
                                               double text, double width) {
    std::vector<std::vector<std::string>> ids;
    for (const Pattern& pattern : patterns)
        ids.push_back(detail::lines_within(pattern_id(layout, pattern), text, width));
    return ids;
}

double most_lines(std::span<const std::vector<std::string>> texts) {
    std::size_t most = 1;
    for (const auto& lines : texts) most = std::max(most, lines.size());
    return static_cast<double>(most);
}

/// Draw the key of the colours: a line of swatches with numbers of edges.
void draw_key(SvgCanvas& canvas, std::span<const Pattern> patterns, const Point2& start, double text) {
    std::set<int> counts;
    for (const Pattern& pattern : patterns) counts.insert(pattern.edge_count());
    Point2 place = start;
    const auto write = [&](const std::string& words) {
        canvas.text(place, words, text);
        place.x += detail::text_width(words, text) + 0.8 * text;
    };
    write("edges:");
    for (const int count : counts) {
        const std::array<Point2, 4> swatch = {place, Point2{place.x + text, place.y},
                                              Point2{place.x + text, place.y + 0.75 * text},
                                              Point2{place.x, place.y + 0.75 * text}};
        canvas.polygon(swatch, {pattern_colour(count), detail::kRimColour, 0.05 * text, 1.0});
        place.x += 1.3 * text;
        write(std::to_string(count));
    }
}

}  // namespace

std::string pattern_sheet_svg(const NodeLayout& layout, std::span<const Pattern> patterns,
                              const PatternDrawingOptions& options) {
    const auto count = static_cast<int>(patterns.size());
    const int cells = count + 1;  // the first is the layout's
    const int columns = static_cast<int>(std::ceil(std::sqrt(1.4 * cells)));
    const int rows = (cells + columns - 1) / columns;
    const double side = options.tile_side;
    const double step_x = 2.15 * side;
    const detail::SheetPrint print = detail::sheet_print(columns, step_x);
    const double text = std::max(0.13 * side, print.text);
    const auto ids = id_lines(layout, patterns, text, 0.97 * step_x);
    const double step_y = 2.05 * side + (0.6 + detail::kLineStep * most_lines(ids)) * text;
    SvgCanvas canvas({-0.5 * step_x, side - rows * step_y - (count > 0 ? 1.5 * text : 0.0),
                      (columns - 0.5) * step_x, 1.12 * side},
                     1.0);
    canvas.print_as_wide_as(print.width);
    draw_layout(canvas, layout, side, text);
    for (int i = 0; i < count; ++i) {
        const int cell = i + 1;
        const int row = cell / columns;
        const Point2 center{(cell % columns) * step_x, -row * step_y};
        const Pattern& pattern = patterns[i];
        detail::draw_fan(canvas, layout, pattern, {center, pattern_colour(pattern.edge_count())}, options);
        detail::write_lines(canvas, {center.x, center.y - side - text}, ids[i], text);
    }
    if (count > 0)
        draw_key(canvas, patterns, {canvas.box().xmin + 0.5 * text, canvas.box().ymin + 0.6 * text}, text);
    return canvas.document(std::to_string(count) + " patterns of layout " + layout.name());
}

}  // namespace fretwork::exports
