// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/drawings/detail/fan_drawing.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/print.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>
#include <fretwork/exports/tables/line_set.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::exports {
namespace {

using detail::kInterfaceColour;
using detail::SvgCanvas;
using geometry::Point2;
using reduction::Calibration;
using reduction::Setting;

/// A tile model of beams, as one drawing of the sheet.
struct ReducedTile {
    LineSet lines;  ///< interface nodes first
    int interface_nodes;
    Point2 center;
};

void draw_reduced(SvgCanvas& canvas, const ReducedTile& tile, const Setting& setting) {
    const auto& [lines, interface_nodes, center] = tile;
    std::vector<Point2> nodes;
    for (const Eigen::Vector3d& node : lines.nodes)
        nodes.push_back({node.x() + center.x, node.y() + center.y});
    const double width = mechanics::section_width(setting.section);
    canvas.polygon(detail::moved(geometry::regular_polygon(setting.sides, setting.tile_side), center),
                   {"#f4f6f8", detail::kRimColour, 0.15 * width, 1.0});
    canvas.segments(detail::segments_of(lines.lines, nodes), {"none", detail::kReducedColour, width, 1.0});
    for (int i = 0; i < interface_nodes; ++i)
        canvas.circle(nodes[i], 0.8 * width, {kInterfaceColour, "#ffffff", 0.2 * width, 1.0});
}

/// The caption of a reduced model, in lines.
std::vector<std::string> facts(const std::optional<Calibration>& calibration,
                               std::span<const reduction::TileModel> models) {
    if (!calibration) return {"not calibrated"};
    const reduction::TileModel& model = reduction::find_tile_model(calibration->model, models);
    std::vector<std::string> lines;
    for (const reduction::TileParameter& parameter : model.parameters) {
        if (parameter.unit != "rad") continue;
        const double value =
            reduction::parameter_values(*calibration, model)[parameter_index(model, parameter.name)];
        lines.push_back(parameter.name + " = " + detail::short_number(value * 180.0 / std::acos(-1.0)) +
                        "\xc2\xb0");
    }
    lines.push_back("E = " + detail::short_number(calibration->objective));
    return lines;
}

/// The number of columns of pairs: at most two for a journal's column, four for a page, else more.
int columns_of(int pairs) {
    constexpr int kMostInColumn = 8;
    constexpr int kMostOnPage = 24;
    if (pairs <= kMostInColumn) return std::clamp(pairs, 1, 2);
    if (pairs <= kMostOnPage) return 4;
    return static_cast<int>(std::ceil(std::sqrt(0.7 * pairs)));
}

}  // namespace

std::string reduced_sheet_svg(const pattern::NodeLayout& layout, std::span<const ReducedPattern> patterns,
                              const Setting& setting, std::span<const reduction::TileModel> models) {
    const double side = setting.tile_side;
    const PatternDrawingOptions options{side, mechanics::section_width(setting.section), setting.sides};
    const auto count = static_cast<int>(patterns.size());
    const int interface_nodes = setting.sides * static_cast<int>(layout.interface_nodes().size());
    const int columns = columns_of(count);
    const int rows = std::max(1, (count + columns - 1) / columns);
    const double step_x = 4.4 * side;
    const detail::SheetPrint print = detail::sheet_print(2 * columns, 0.5 * step_x);
    const double text = std::max(0.13 * side, print.text);
    std::vector<std::vector<std::string>> ids;
    std::vector<std::vector<std::string>> known;
    std::size_t most_lines = 1;
    for (const ReducedPattern& entry : patterns) {
        ids.push_back(detail::lines_within(pattern_id(layout, entry.pattern), text, 2.1 * side));
        known.push_back(facts(entry.calibration, models));
        most_lines = std::max({most_lines, ids.back().size(), known.back().size()});
    }
    const double step_y = 2.05 * side + (0.6 + detail::kLineStep * static_cast<double>(most_lines)) * text;
    SvgCanvas canvas({-1.15 * side, side - rows * step_y, columns * step_x - 1.15 * side, side}, 1.0);
    canvas.print_as_wide_as(print.width);
    for (int i = 0; i < count; ++i) {
        const ReducedPattern& entry = patterns[i];
        const int row = i / columns;
        const Point2 left{(i % columns) * step_x, -row * step_y};
        const Point2 right{left.x + 2.1 * side, left.y};
        detail::draw_fan(canvas, layout, entry.pattern, {left, pattern_colour(i)}, options);
        if (entry.calibration)
            draw_reduced(canvas,
                         {model_lines(layout, entry.pattern, *entry.calibration, setting, models),
                          interface_nodes, right},
                         setting);
        detail::write_lines(canvas, {left.x, left.y - side - text}, ids[i], text);
        detail::write_lines(canvas, {right.x, right.y - side - text}, known[i], text);
    }
    return canvas.document(std::to_string(count) + " patterns and their reduced models");
}

}  // namespace fretwork::exports
