// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/detail/svg_canvas.hpp>
#include <fretwork/exports/surface_drawing.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace fretwork::exports {
namespace {

using detail::Anchor;
using detail::Box;
using detail::SvgCanvas;
using pattern::Point2;

/// Parallel projection onto the plane across the line of sight.
class Projection {
  public:
    explicit Projection(const DeformedViewOptions& options)
        : right_(std::cos(options.azimuth), std::sin(options.azimuth), 0.0),
          up_(-std::sin(options.elevation) * std::sin(options.azimuth),
              std::sin(options.elevation) * std::cos(options.azimuth), std::cos(options.elevation)) {}
    [[nodiscard]] Point2 operator()(const Eigen::Vector3d& point) const {
        return {right_.dot(point), up_.dot(point)};
    }

  private:
    Eigen::Vector3d right_;
    Eigen::Vector3d up_;
};

std::vector<Point2> projected(const std::vector<Eigen::Vector3d>& nodes, const Projection& projection) {
    std::vector<Point2> points;
    points.reserve(nodes.size());
    for (const Eigen::Vector3d& node : nodes) points.push_back(projection(node));
    return points;
}

std::vector<std::array<Point2, 2>> segments_of(const LineSet& lines, const std::vector<Point2>& points) {
    std::vector<std::array<Point2, 2>> segments;
    for (const auto& line : lines.lines) {
        segments.push_back(
            {points[static_cast<std::size_t>(line[0])], points[static_cast<std::size_t>(line[1])]});
    }
    return segments;
}

/// 1, 2 or 5 times a power of ten: the largest that is no more than `most`.
double round_length(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= most) return factor * power;
    }
    return power;
}

std::string millimetres(double metres) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4g mm", 1e3 * metres);
    return buffer;
}

void draw_scale_bar(SvgCanvas& canvas, const Box& box) {
    const double size = round_length(0.2 * box.width());
    const double height = 0.018 * box.width();
    const Point2 start{box.xmin + 0.03 * box.width(), box.ymin + 0.03 * box.width()};
    const std::array<std::array<Point2, 2>, 1> bar = {{{start, Point2{start.x + size, start.y}}}};
    canvas.segments(bar, {"none", "#333", 0.003 * box.width(), 1.0});
    canvas.text({start.x, start.y + 0.6 * height}, millimetres(size), height);
}

std::string scale_note(double scale) {
    return scale == 1.0 ? "displacements at true scale" : "displacements times " + base::format_number(scale);
}

/// A line of the legend, from the top left corner of the box down.
Point2 legend_place(const Box& box, int line) {
    return {box.xmin + 0.03 * box.width(), box.ymax - (0.03 + 0.028 * (line + 1)) * box.width()};
}

void draw_legend(SvgCanvas& canvas, const Box& box, std::span<const DeformedLayer> layers, double scale) {
    const double height = 0.018 * box.width();
    int line = 0;
    for (const DeformedLayer& layer : layers) {
        const Point2 place = legend_place(box, line++);
        const std::array<std::array<Point2, 2>, 1> sample = {
            {{Point2{place.x, place.y + 0.35 * height},
              Point2{place.x + 2.2 * height, place.y + 0.35 * height}}}};
        canvas.segments(sample, {"none", layer.colour, 0.25 * height, 1.0});
        canvas.text({place.x + 2.8 * height, place.y}, layer.label, height);
    }
    canvas.text(legend_place(box, line), scale_note(scale), height);
}

/// Room for the legend above and the scale bar below.
Box with_rims(Box box, int legend_lines) {
    const double margin = 0.04 * box.width();
    const double width = box.width() + 2 * margin;
    return {box.xmin - margin, box.ymin - margin - 0.06 * width, box.xmax + margin,
            box.ymax + margin + (0.03 + 0.028 * (legend_lines + 1)) * width};
}

double line_width(const Box& box) {
    return 0.0022 * box.width();
}

/// The picture is as wide as this, whatever it shows.
double picture_scale(const Box& box) {
    constexpr double kPictureWidth = 0.26;  // metres: a sheet of A4 on its side
    return kPictureWidth / box.width();
}

}  // namespace

std::string deformed_svg(std::span<const DeformedLayer> layers, const DeformedViewOptions& options) {
    const Projection projection(options);
    std::vector<std::vector<Point2>> points;
    std::vector<Point2> all;
    for (const DeformedLayer& layer : layers) {
        points.push_back(projected(displaced_nodes(layer.lines, options.scale), projection));
        all.insert(all.end(), points.back().begin(), points.back().end());
    }
    const Box box = with_rims(detail::bounding_box(all, 0.0), static_cast<int>(layers.size()) + 1);
    SvgCanvas canvas(box, picture_scale(box));
    for (std::size_t i = 0; i < layers.size(); ++i) {
        canvas.segments(segments_of(layers[i].lines, points[i]),
                        {"none", layers[i].colour, line_width(box), 0.85});
    }
    draw_legend(canvas, box, layers, options.scale);
    draw_scale_bar(canvas, box);
    return canvas.document("Deformed state, " + scale_note(options.scale));
}

std::string displacement_svg(const DeformedLayer& layer, const DeformedViewOptions& options) {
    const std::vector<Point2> points =
        projected(displaced_nodes(layer.lines, options.scale), Projection(options));
    const Box box = with_rims(detail::bounding_box(points, 0.0), 3);
    SvgCanvas canvas(box, picture_scale(box));
    std::vector<double> sizes(points.size(), 0.0);
    for (std::size_t i = 0; i < sizes.size() && layer.lines.displacements; ++i) {
        sizes[i] = layer.lines.displacements->row(static_cast<Eigen::Index>(i)).head<3>().norm();
    }
    const double largest = std::max(*std::max_element(sizes.begin(), sizes.end()), 1e-300);

    constexpr int kBands = 16;  // lines of one colour are one path: a small file
    std::vector<std::vector<std::array<Point2, 2>>> bands(kBands);
    for (const auto& line : layer.lines.lines) {
        const auto a = static_cast<std::size_t>(line[0]);
        const auto b = static_cast<std::size_t>(line[1]);
        const double share = 0.5 * (sizes[a] + sizes[b]) / largest;
        bands[std::min<std::size_t>(static_cast<std::size_t>(kBands * share), kBands - 1)].push_back(
            {points[a], points[b]});
    }
    for (int band = 0; band < kBands; ++band) {
        canvas.segments(bands[static_cast<std::size_t>(band)],
                        {"none", scale_colour((band + 0.5) / kBands), 1.4 * line_width(box), 1.0});
    }

    const double height = 0.018 * box.width();
    const Point2 corner = legend_place(box, 1);
    const double step = 0.3 * box.width() / kBands;
    for (int band = 0; band < kBands; ++band) {
        const double x = corner.x + band * step;
        const std::array<Point2, 4> swatch = {Point2{x, corner.y}, Point2{x + step, corner.y},
                                              Point2{x + step, corner.y + height},
                                              Point2{x, corner.y + height}};
        canvas.polygon(swatch, {scale_colour((band + 0.5) / kBands), "none", 0.0, 1.0});
    }
    canvas.text(legend_place(box, 0), layer.label + ": size of the displacement", height);
    canvas.text({corner.x, corner.y - 1.3 * height}, "0", height);
    canvas.text({corner.x + kBands * step, corner.y - 1.3 * height}, millimetres(largest), height,
                Anchor::End);
    canvas.text(legend_place(box, 3), scale_note(options.scale), height);
    draw_scale_bar(canvas, box);
    return canvas.document("Displacements, " + scale_note(options.scale));
}

}  // namespace fretwork::exports
