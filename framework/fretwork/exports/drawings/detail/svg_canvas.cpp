// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/exports/detail/markup.hpp>
#include <fretwork/exports/drawings/detail/svg_canvas.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace fretwork::exports::detail {
namespace {

using geometry::Box;
using geometry::Point2;

/// Rounded to 0.001: no printer or eye resolves a micrometre.
std::string rounded(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3f", value);
    std::string text = buffer;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

/// Only ids contain this: quotes in texts are escaped.
constexpr std::string_view kIdStart = " id=\"";

/// Text that is valid as an id: other characters become hyphens.
std::string identifier(std::string_view name) {
    std::string text;
    for (const char c : name) text += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
    return text;
}

}  // namespace

Box bounding_box(std::span<const Point2> points, double margin) {
    if (points.empty()) return {-margin, -margin, margin, margin};
    return geometry::grown(geometry::box_of(points), margin);
}

std::vector<Point2> moved(std::vector<Point2> points, const Point2& by) {
    for (Point2& point : points) point = point + by;
    return points;
}

SvgCanvas::SvgCanvas(const Box& box, double scale) : box_(box), units_per_metre_(1000.0 * scale) {}

std::string SvgCanvas::place(const Point2& point) const {
    return rounded((point.x - box_.xmin) * units_per_metre_) + "," +
           rounded((box_.ymax - point.y) * units_per_metre_);
}

std::string SvgCanvas::length(double metres) const {
    return rounded(metres * units_per_metre_);
}

std::string SvgCanvas::attributes(const Style& style) const {
    std::string text = " fill=\"" + style.fill + "\"";
    if (style.stroke != "none") {
        text += " stroke=\"" + style.stroke + "\" stroke-width=\"" + length(style.stroke_width) +
                "\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    }
    if (style.dash > 0.0) text += " stroke-dasharray=\"" + length(style.dash) + "\"";
    if (style.opacity < 1.0) text += " opacity=\"" + rounded(style.opacity) + "\"";
    return text;
}

void SvgCanvas::polygon(std::span<const Point2> points, const Style& style) {
    body_ += "<polygon points=\"";
    for (const Point2& point : points) body_ += (&point == points.data() ? "" : " ") + place(point);
    body_ += "\"" + attributes(style) + "/>\n";
}

void SvgCanvas::named_polygon(std::span<const Point2> points, const Style& style, std::string_view id,
                              std::string_view name) {
    body_ += "<polygon id=\"" + escaped(id) + "\" points=\"";
    for (const Point2& point : points) body_ += (&point == points.data() ? "" : " ") + place(point);
    body_ += "\"" + attributes(style) + "><title>" + escaped(name) + "</title></polygon>\n";
}

void SvgCanvas::segments(std::span<const geometry::Segment> lines, const Style& style) {
    named_segments(lines, style, "");
}

void SvgCanvas::named_segments(std::span<const geometry::Segment> lines, const Style& style,
                               std::string_view id) {
    if (lines.empty()) return;
    body_ += "<path";
    if (!id.empty()) body_ += std::string(kIdStart) + escaped(id) + "\"";
    body_ += " d=\"";
    for (const auto& line : lines) body_ += "M" + place(line[0]) + "L" + place(line[1]);
    body_ += "\"" + attributes(style) + "/>\n";
}

void SvgCanvas::circle(const Point2& center, double radius, const Style& style) {
    body_ += "<circle cx=\"" + rounded((center.x - box_.xmin) * units_per_metre_) + "\" cy=\"" +
             rounded((box_.ymax - center.y) * units_per_metre_) + "\" r=\"" + length(radius) + "\"" +
             attributes(style) + "/>\n";
}

void SvgCanvas::ball(const Point2& center, double radius, const Colour& colour) {
    circle(center, radius, {colour, "#ffffff", 0.15 * radius, 1.0});
    circle({center.x - 0.3 * radius, center.y + 0.35 * radius}, 0.28 * radius,
           {"#ffffff", "none", 0.0, 0.65});
}

void SvgCanvas::arrow(const Point2& from, const Point2& to, double head, const Style& style) {
    const double size = geometry::distance(from, to);
    if (size == 0.0) return;
    const Point2 along{(to.x - from.x) / size, (to.y - from.y) / size};
    const double tip = std::min(head, size);
    const Point2 neck{to.x - tip * along.x, to.y - tip * along.y};
    const std::array<std::array<Point2, 2>, 1> shaft = {{{from, neck}}};
    segments(shaft, style);
    const double half = 0.4 * tip;
    const std::array<Point2, 3> triangle = {to, Point2{neck.x - half * along.y, neck.y + half * along.x},
                                            Point2{neck.x + half * along.y, neck.y - half * along.x}};
    polygon(triangle, {style.stroke, "none", 0.0, style.opacity});
}

void SvgCanvas::text(const Point2& point, std::string_view text, double height, Anchor anchor) {
    constexpr const char* kAnchors[] = {"start", "middle", "end"};
    body_ += "<text x=\"" + rounded((point.x - box_.xmin) * units_per_metre_) + "\" y=\"" +
             rounded((box_.ymax - point.y) * units_per_metre_) + "\" font-size=\"" + length(height) +
             "\" text-anchor=\"" + kAnchors[static_cast<int>(anchor)] + "\" fill=\"#333\">" + escaped(text) +
             "</text>\n";
}

void SvgCanvas::layer(std::string_view name) {
    body_ += std::string(in_layer_ ? "</g>\n" : "") + "<g" + std::string(kIdStart) + identifier(name) +
             "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + escaped(name) + "\">\n";
    in_layer_ = true;
}

std::string SvgCanvas::body() const {
    return body_ + (in_layer_ ? "</g>\n" : "");
}

std::string SvgCanvas::size(std::string_view unit, double factor) const {
    const double width = box_.width() * units_per_metre_;
    const double height = box_.height() * units_per_metre_;
    return "width=\"" + rounded(factor * width) + std::string(unit) + "\" height=\"" +
           rounded(factor * height) + std::string(unit) + "\" viewBox=\"0 0 " + rounded(width) + " " +
           rounded(height) + "\"";
}

void SvgCanvas::embed(const SvgCanvas& drawing, const Point2& top_left, double width, std::string_view name) {
    const double factor = width * units_per_metre_ / (drawing.box_.width() * drawing.units_per_metre_);
    std::string body = drawing.body();
    for (std::size_t at = body.find(kIdStart); at != std::string::npos; at = body.find(kIdStart, at + 1))
        body.insert(at + kIdStart.size(), identifier(name) + "-");
    body_ += "<svg x=\"" + rounded((top_left.x - box_.xmin) * units_per_metre_) + "\" y=\"" +
             rounded((box_.ymax - top_left.y) * units_per_metre_) + "\" " + drawing.size("", factor) + ">\n" +
             body + "</svg>\n";
}

std::string SvgCanvas::document(std::string_view title) const {
    const std::string print =
        print_width_ > 0.0 ? " data-print-width=\"" + rounded(1e3 * print_width_) + "mm\"" : "";
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- " + std::string(base::kMadeBy) +
           " -->\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
           "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " +
           size("mm", 1.0) + print + " font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n<title>" +
           escaped(title) + "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + body() +
           "</svg>\n";
}

}  // namespace fretwork::exports::detail
