// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/fan_drawing.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/pattern/fan.hpp>

#include <vector>

namespace fretwork::exports::detail {
namespace {

using geometry::Point2;
using pattern::NodeLayout;
using pattern::Pattern;

constexpr const char* kGuiltyColour = "#d7191c";

}  // namespace

void draw_fan_beams(SvgCanvas& canvas, const NodeLayout& layout, const Pattern& pattern,
                    const geometry::Polygon& polygon, const Style& style) {
    const pattern::Fan fan = pattern::make_fan(layout, pattern, static_cast<int>(polygon.size()));
    const std::vector<Point2> nodes = pattern::place_fan(layout, fan, polygon);
    canvas.segments(segments_of(fan.edges, nodes), style);
}

void draw_fan(SvgCanvas& canvas, const NodeLayout& layout, const Pattern& pattern, const FanPlace& place,
              const PatternDrawingOptions& options, const Pattern& guilty) {
    const geometry::Polygon polygon =
        moved(geometry::regular_polygon(options.sides, options.tile_side), place.center);
    canvas.polygon(polygon, {place.face, kRimColour, 0.15 * options.beam_width, 1.0});
    draw_fan_beams(canvas, layout, pattern, polygon, {"none", kBeamColour, options.beam_width, 1.0});
    if (guilty.edge_count() > 0)
        draw_fan_beams(canvas, layout, guilty, polygon, {"none", kGuiltyColour, options.beam_width, 1.0});
}

}  // namespace fretwork::exports::detail
