// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/print.hpp>

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

/// The width as a share of the height, in DejaVu Sans; other fonts are narrower.
double character_width(char c) {
    constexpr std::string_view kNarrow = "iljI|.,:;' ()";
    constexpr std::string_view kMiddle = "-frtsJ";
    constexpr std::string_view kWide = "mwMW+=%@";
    if (kNarrow.find(c) != std::string_view::npos) return 0.37;
    if (kMiddle.find(c) != std::string_view::npos) return c == '-' ? 0.37 : 0.48;
    if (kWide.find(c) != std::string_view::npos) return c == 'm' || c == 'W' || c == '@' ? 0.99 : 0.86;
    if ((static_cast<unsigned char>(c) & 0xc0U) == 0x80U) return 0.0;  // the rest of a character of UTF-8
    return c >= 'A' && c <= 'Z' ? 0.72 : 0.635;
}

}  // namespace

double text_height(double drawing_width) {
    return legible_height(drawing_width, kColumnWidth);
}

double text_width(std::string_view text, double height) {
    double width = 0.0;
    for (const char c : text) width += character_width(c);
    return width * height;
}

std::vector<std::string> lines_within(std::string_view text, double height, double width) {
    std::vector<std::string> lines(1);
    std::size_t at = 0;
    while (at < text.size()) {
        std::size_t end = at + 1;
        while (end < text.size() && text[end] != '+' && text[end - 1] != ' ') ++end;
        const std::string part(text.substr(at, end - at));
        if (!lines.back().empty() && text_width(lines.back() + part, height) > width) lines.emplace_back();
        lines.back() += part;
        at = end;
    }
    for (std::string& line : lines) {
        while (line.ends_with(' ')) line.pop_back();
    }
    return lines;
}

void write_lines(SvgCanvas& canvas, const Point2& place, std::span<const std::string> lines, double height) {
    double y = place.y;
    for (const std::string& line : lines) {
        canvas.text({place.x, y}, line, height, Anchor::Middle);
        y -= kLineStep * height;
    }
}

std::string short_number(double value) {
    return base::format_number(value, 3);
}

std::string millimetres(double metres) {
    return base::format_number(1e3 * metres, 4) + " mm";
}

void draw_scale_bar(SvgCanvas& canvas, const Point2& start, double height) {
    const double size = round_length(0.2 * canvas.box().width());
    const double tick = 0.3 * height;
    const Point2 end{start.x + size, start.y};
    const std::array<std::array<Point2, 2>, 3> bar = {
        {{start, end},
         {Point2{start.x, start.y - tick}, Point2{start.x, start.y + tick}},
         {Point2{end.x, end.y - tick}, Point2{end.x, end.y + tick}}}};
    canvas.segments(bar, {"none", kTextColour, 0.1 * height, 1.0});
    canvas.text({start.x, start.y + 0.5 * height}, millimetres(size), height);
}

Point2 draw_line_sample(SvgCanvas& canvas, const Point2& place, const Style& style, double height) {
    const double middle = place.y + 0.35 * height;
    const std::array<std::array<Point2, 2>, 1> sample = {
        {{Point2{place.x, middle}, Point2{place.x + 2.4 * height, middle}}}};
    canvas.segments(sample, style);
    return {place.x + 3.2 * height, place.y};
}

}  // namespace fretwork::exports::detail
