// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>

#include <cmath>

namespace fretwork::exports::detail {
namespace {

using geometry::Point2;

/// The largest of 1, 2 or 5 times a power of ten that is at most `most`.
double round_length(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= most) return factor * power;
    }
    return power;
}

}  // namespace

double text_height(double drawing_width) {
    return 0.017 * drawing_width;
}

double text_width(std::string_view text, double height) {
    return 0.64 * height * static_cast<double>(text.size());
}

std::string short_number(double value) {
    return base::format_number(value, 3);
}

std::string millimetres(double metres) {
    return base::format_number(1e3 * metres, 4) + " mm";
}

void draw_scale_bar(SvgCanvas& canvas, const Point2& start) {
    const double width = canvas.box().width();
    const double height = text_height(width);
    const double size = round_length(0.2 * width);
    const double tick = 0.3 * height;
    const Point2 end{start.x + size, start.y};
    const std::array<std::array<Point2, 2>, 3> bar = {
        {{start, end},
         {Point2{start.x, start.y - tick}, Point2{start.x, start.y + tick}},
         {Point2{end.x, end.y - tick}, Point2{end.x, end.y + tick}}}};
    canvas.segments(bar, {"none", kTextColour, 0.1 * height, 1.0});
    canvas.text({start.x + 0.5 * size, start.y + 0.5 * height}, millimetres(size), 0.9 * height,
                Anchor::Middle);
}

Point2 draw_line_sample(SvgCanvas& canvas, const Point2& place, const Style& style) {
    const double height = text_height(canvas.box().width());
    const double middle = place.y + 0.35 * height;
    const std::array<std::array<Point2, 2>, 1> sample = {
        {{Point2{place.x, middle}, Point2{place.x + 2.4 * height, middle}}}};
    canvas.segments(sample, style);
    return {place.x + 3.2 * height, place.y};
}

}  // namespace fretwork::exports::detail
