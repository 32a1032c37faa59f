// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/panels.hpp>
#include <fretwork/exports/drawings/detail/projection.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace fretwork::exports::detail {
namespace {

using geometry::Box;
using geometry::Point2;

constexpr int kBands = 16;           ///< colours of a scale
constexpr double kLegendStep = 1.5;  ///< between lines of a legend, in text heights
constexpr double kEdge = 2.4;        ///< width of the white edge, which hides lines behind, in line widths

/// The lengths of all displacements; zeros if there are no results.
std::vector<double> displacement_sizes(const LineSet& lines) {
    std::vector<double> sizes(lines.nodes.size(), 0.0);
    for (std::size_t i = 0; i < sizes.size() && lines.displacements; ++i)
        sizes[i] = lines.displacements->row(i).head<3>().norm();
    return sizes;
}

double largest_displacement(const LineSet& lines) {
    const std::vector<double> sizes = displacement_sizes(lines);
    return sizes.empty() ? 0.0 : *std::ranges::max_element(sizes);
}

/// A deformed view before its annotations: projected lines, and the box with room for a legend above and a
/// scale bar below.
struct View {
    std::vector<std::vector<Point2>> points;      ///< for each layer
    std::vector<std::vector<double>> nearnesses;  ///< of these points to the viewer, m
    std::vector<Point2> rest;
    Box box;
};

View make_view(std::span<const DeformedLayer> layers, const DeformedViewOptions& options, int legend_lines) {
    const Projection projection(options.view);
    View view;
    view.rest = projection.all(options.rest.nodes);
    std::vector<Point2> all = view.rest;
    for (const DeformedLayer& layer : layers) {
        const auto places = displaced_nodes(layer.lines, options.scale);
        view.points.push_back(projection.all(places));
        view.nearnesses.emplace_back();
        for (const Eigen::Vector3d& place : places)
            view.nearnesses.back().push_back(projection.nearness(place));
        all.insert(all.end(), view.points.back().begin(), view.points.back().end());
    }
    const Box subject = bounding_box(all, 0.0);
    const double margin = 0.03 * subject.width();
    view.box = {subject.xmin - margin, subject.ymin - margin, subject.xmax + margin, subject.ymax + margin};
    const double text = text_height(view.box.width());
    view.box.ymax += kLegendStep * text * legend_lines;
    view.box.ymin -= 2.0 * text;
    return view;
}

double line_width(const Box& box) {
    return 0.0018 * box.width();
}

Style rest_style(const Box& box) {
    return {"none", "#9aa4ae", 0.7 * line_width(box), 1.0, 3.0 * line_width(box)};
}

/// A line of the legend, from the top left corner of the box down.
Point2 legend_place(const Box& box, int line) {
    const double text = text_height(box.width());
    return {box.xmin + text, box.ymax - kLegendStep * text * (line + 1)};
}

void draw_rest(SvgCanvas& canvas, const View& view, const DeformedViewOptions& options) {
    canvas.layer("at rest");
    canvas.segments(segments_of(options.rest.lines, view.rest), rest_style(view.box));
}

/// The last lines of every legend. `line` is the first free one.
void draw_notes(SvgCanvas& canvas, const DeformedViewOptions& options, int line) {
    const double text = text_height(canvas.box().width());
    if (!options.rest.lines.empty()) {
        const Point2 place =
            draw_line_sample(canvas, legend_place(canvas.box(), line++), rest_style(canvas.box()), text);
        canvas.text(place, "rim at rest", text);
    }
    canvas.text(legend_place(canvas.box(), line),
                scale_note(options.scale) + ", " + joints_note(options.joints), text);
    draw_scale_bar(canvas, {canvas.box().xmin + text, canvas.box().ymin + 0.6 * text}, text);
}

void draw_colour_bar(SvgCanvas& canvas, const Point2& start, double width) {
    const double text = text_height(canvas.box().width());
    const double step = width / kBands;
    for (int band = 0; band < kBands; ++band) {
        const double x = start.x + band * step;
        // Each swatch reaches under the next: otherwise, renderers that smooth edges would show seams.
        const double end = band + 1 < kBands ? x + 1.5 * step : x + step;
        const std::array<Point2, 4> swatch = {Point2{x, start.y}, Point2{end, start.y},
                                              Point2{end, start.y + text}, Point2{x, start.y + text}};
        canvas.polygon(swatch, {scale_colour((band + 0.5) / kBands), "none", 0.0, 1.0});
    }
}

/// The white edges below lines. Where lines meet, a white edge begins only where it is clear of the lines
/// that are drawn already: otherwise, it would cut wedges out of them.
class WhiteEdges {
  public:
    WhiteEdges(const LineSet& lines, const Segments& segments, double width)
        : lines_(lines), segments_(segments), width_(width), drawn_at_(lines.nodes.size()) {}

    void draw(SvgCanvas& canvas, std::size_t line) {
        const auto& [start, end] = segments_[line];
        const double length = geometry::distance(start, end);
        const double first = gap(line, 0);
        const double last = gap(line, 1);
        for (const int node : lines_.lines[line]) drawn_at_[node].push_back(line);
        if (!(first + last < length)) return;
        const Segments edge = {{geometry::between(start, end, first / length),
                                geometry::between(start, end, 1.0 - last / length)}};
        canvas.segments(edge, {"none", "#ffffff", kEdge * width_, 1.0});
    }

  private:
    /// The distance from an end of a line to where its white edge is clear of the lines that are drawn there.
    [[nodiscard]] double gap(std::size_t line, std::size_t end) const {
        const int node = lines_.lines[line][end];
        double gap = 0.0;
        for (const std::size_t other : drawn_at_[node])
            gap = std::max(gap, parting(away_from(line, node), away_from(other, node)));
        return gap;
    }

    [[nodiscard]] Point2 away_from(std::size_t line, int node) const {
        const std::size_t here = lines_.lines[line][0] == node ? 0 : 1;
        const Point2& from = segments_[line][here];
        const Point2& to = segments_[line][1 - here];
        return {to.x - from.x, to.y - from.y};
    }

    /// The distance along a line up to which its white edge meets another line from the same node. It is at
    /// most the reach of the other line.
    [[nodiscard]] double parting(const Point2& line, const Point2& other) const {
        const double clear =
            0.5 * (kEdge + 1.0) * width_;  // between the axes of a white edge and a line that just touch
        const double angle = std::abs(geometry::turn(line, other));
        if (angle >= 0.5 * std::numbers::pi) return clear;
        const double reach = geometry::length(other) + clear;
        return clear < reach * std::sin(angle) ? clear / std::sin(angle) : reach;
    }

    const LineSet& lines_;
    const Segments& segments_;
    double width_;
    std::vector<std::vector<std::size_t>> drawn_at_;  ///< by node
};

/// The content below the lines of a layer.
enum class Below { Nothing, OtherStates };

/// The lines of a layer of a view.
struct SeenLines {
    const LineSet& lines;
    const std::vector<Point2>& points;
    const std::vector<double>& nearnesses;  ///< of nodes
    double width;

    [[nodiscard]] double of_ends(const std::vector<double>& values, std::size_t line) const {
        return 0.5 * (values[lines.lines[line][0]] + values[lines.lines[line][1]]);
    }
};

/// Draw the lines, the farthest middle first, so that nearer lines hide those behind them. Lines over other
/// states have no white edges, because these would cut the lines of the other states.
/// @param colour_of  gives a line's colour
template <class ColourOf>
void draw_lines(SvgCanvas& canvas, const SeenLines& seen, Below below, const ColourOf& colour_of) {
    std::vector<std::size_t> order(seen.lines.lines.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return seen.of_ends(seen.nearnesses, i); });
    const Segments segments = segments_of(seen.lines.lines, seen.points);
    WhiteEdges edges(seen.lines, segments, seen.width);
    for (const std::size_t i : order) {
        if (below == Below::Nothing) edges.draw(canvas, i);
        canvas.segments(std::span(&segments[i], 1), {"none", colour_of(i), seen.width, 1.0});
    }
}

void draw_coloured_lines(SvgCanvas& canvas, const LineSet& lines, const View& view, double largest) {
    const std::vector<double> sizes = displacement_sizes(lines);
    const SeenLines seen{lines, view.points.front(), view.nearnesses.front(), 1.6 * line_width(canvas.box())};
    draw_lines(canvas, seen, Below::Nothing, [&](std::size_t line) {
        const int band = std::min(static_cast<int>(kBands * seen.of_ends(sizes, line) / largest), kBands - 1);
        return scale_colour((band + 0.5) / kBands);
    });
}

}  // namespace

std::string joints_note(reduction::Joints joints) {
    return "joints: " + std::string(reduction::joints_name(joints));
}

std::string scale_note(double scale) {
    return scale == 1.0 ? "displacements at true scale"
                        : "displacements " + base::format_number(scale) + " times as large";
}

SvgCanvas deformed_panel(std::span<const DeformedLayer> layers, const DeformedViewOptions& options) {
    const int notes = options.rest.lines.empty() ? 1 : 2;
    const View view = make_view(layers, options, static_cast<int>(layers.size()) + notes);
    SvgCanvas canvas(view.box, 1.0);
    const double text = text_height(view.box.width());
    draw_rest(canvas, view, options);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        canvas.layer(layers[i].label);
        // The first layer is wider: it shows beside those upon it.
        const double width = (i == 0 ? 1.0 : 0.8) * line_width(view.box);
        draw_lines(canvas, {layers[i].lines, view.points[i], view.nearnesses[i], width},
                   i == 0 ? Below::Nothing : Below::OtherStates,
                   [&](std::size_t) { return layers[i].colour; });
    }
    canvas.layer("legend");
    int line = 0;
    for (const DeformedLayer& layer : layers) {
        const Point2 place = draw_line_sample(canvas, legend_place(view.box, line++),
                                              {"none", layer.colour, 0.25 * text, 1.0}, text);
        canvas.text(place, layer.label + ": at most " + millimetres(largest_displacement(layer.lines)), text);
    }
    draw_notes(canvas, options, line);
    return canvas;
}

SvgCanvas displacement_panel(const DeformedLayer& layer, const DeformedViewOptions& options) {
    const int notes = options.rest.lines.empty() ? 1 : 2;
    const View view = make_view(std::span(&layer, 1), options, 3 + notes);
    SvgCanvas canvas(view.box, 1.0);
    const double text = text_height(view.box.width());
    const double largest = largest_displacement(layer.lines);
    draw_rest(canvas, view, options);
    canvas.layer(layer.label);
    draw_coloured_lines(canvas, layer.lines, view, std::max(largest, std::numeric_limits<double>::min()));
    canvas.layer("legend");
    canvas.text(legend_place(view.box, 0), layer.label + ": size of the displacement", text);
    const Point2 bar = legend_place(view.box, 1);
    const double width = 0.45 * view.box.width();  // the texts below do not touch
    draw_colour_bar(canvas, bar, width);
    const double below = legend_place(view.box, 2).y + 0.4 * text;
    canvas.text({bar.x, below}, "0", text);
    canvas.text({bar.x + 0.5 * width, below}, millimetres(0.5 * largest), text, Anchor::Middle);
    canvas.text({bar.x + width, below}, millimetres(largest), text, Anchor::End);
    draw_notes(canvas, options, 3);
    return canvas;
}

}  // namespace fretwork::exports::detail
