// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/outlines/svg/svg_geometry.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;

double whole_of(SvgElement::Axis axis, const SvgMeasure& measure) {
    switch (axis) {
        case SvgElement::Axis::X:
            return measure.width;
        case SvgElement::Axis::Y:
            return measure.height;
        default:
            return std::sqrt((measure.width * measure.width + measure.height * measure.height) / 2);
    }
}

/// The share of the free space before the content: "xMin" leaves the space after the content, "xMid" on both
/// sides, "xMax" before it.
double share_before(std::string_view alignment, std::string_view axis) {
    if (alignment.find(std::string(axis) + "Min") != std::string_view::npos) return 0;
    return alignment.find(std::string(axis) + "Max") != std::string_view::npos ? 1 : 0.5;
}

}  // namespace

double SvgElement::length_or(std::string_view name, Axis axis, const SvgMeasure& measure,
                             double missing) const {
    const std::string_view text = properties_.find(name);
    if (text.empty() || text == "auto") return missing;
    const SvgLength length = document_.read(node_, name, text, parse_svg_length);
    switch (length.unit) {
        case SvgLength::Unit::Percent:
            return length.value * whole_of(axis, measure);
        case SvgLength::Unit::Em:
            return length.value * measure.font_size;
        case SvgLength::Unit::Rem:
            return length.value * 16;
        default:
            return length.value;
    }
}

double SvgElement::size_or(std::string_view name, Axis axis, const SvgMeasure& measure,
                           double missing) const {
    const double size = length_or(name, axis, measure, missing);
    if (size < 0)
        document_.fail(node_, std::string(name) + " is \"" + std::string(properties_.find(name)) +
                                  "\", where a length of at least zero is needed");
    return size;
}

std::optional<std::array<double, 4>> SvgElement::view_box() const {
    if (!node_.attribute("viewBox")) return std::nullopt;
    const std::string_view text = node_.attribute("viewBox").value();
    const std::vector<double> box = document_.read(node_, "viewBox", text, [](std::string_view value) {
        SvgText walk(value);
        std::vector<double> numbers;
        while (!walk.at_end()) numbers.push_back(walk.number());
        return numbers;
    });
    if (box.size() != 4 || box[2] < 0 || box[3] < 0)
        document_.fail(node_, "viewBox is \"" + std::string(text.substr(0, 60)) +
                                  "\", where four numbers are needed, the last two at least zero");
    return std::array<double, 4>{box[0], box[1], box[2], box[3]};
}

std::vector<Subpath> SvgElement::subpaths(std::string_view shape, const SvgMeasure& measure) const {
    if (shape == "path") {
        const std::string_view d = node_.attribute("d").value();
        if (d == "none") return {};
        return document_.read(node_, "d", d, parse_svg_path);
    }
    if (shape == "polygon" || shape == "polyline") {
        std::vector<Subpath> lines = polyline();
        lines.front().is_closed = shape == "polygon";
        return lines;
    }
    if (shape == "line") {
        const Point2 from{length_or("x1", Axis::X, measure, 0), length_or("y1", Axis::Y, measure, 0)};
        const Point2 to{length_or("x2", Axis::X, measure, 0), length_or("y2", Axis::Y, measure, 0)};
        return {{{straight(from, to)}}};
    }
    if (shape == "rect") return rectangle(measure);
    return ellipse(shape, measure);
}

Affine SvgElement::transform(const SvgMeasure& measure) const {
    const std::string_view text = properties_.find("transform");
    if (text.empty()) return {};
    const Affine map = document_.read(node_, "transform", text, parse_svg_transform);
    const std::string_view origin = properties_.find("transform-origin");
    if (origin.empty()) return map;
    const std::size_t gap = origin.find(' ');
    const auto place = [&](std::string_view word, double whole) {
        if (word.empty() || word == "center") return whole / 2;
        if (word == "left" || word == "top") return 0.0;
        if (word == "right" || word == "bottom") return whole;
        const SvgLength length = document_.read(node_, "transform-origin", word, parse_svg_length);
        return length.unit == SvgLength::Unit::Percent ? length.value * whole : length.value;
    };
    const double x = place(origin.substr(0, gap), measure.width);
    const double y = place(
        gap == std::string_view::npos ? "" : origin.substr(gap + 1, origin.find(' ', gap + 1) - gap - 1),
        measure.height);
    return Affine{1, 0, 0, 1, x, y}.after(map).after(Affine{1, 0, 0, 1, -x, -y});
}

std::vector<Subpath> SvgElement::polyline() const {
    const std::vector<Point2> points =
        document_.read(node_, "points", node_.attribute("points").value(), parse_svg_points);
    Subpath subpath;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        subpath.pieces.push_back(straight(points[i], points[i + 1]));
    return {subpath};
}

std::vector<Subpath> SvgElement::ellipse(std::string_view shape, const SvgMeasure& measure) const {
    const bool is_circle = shape == "circle";
    const double r = is_circle ? size_or("r", Axis::Both, measure, 0) : 0;
    const double given_x = is_circle ? r : size_or("rx", Axis::X, measure, 0);
    const double given_y = is_circle ? r : size_or("ry", Axis::Y, measure, 0);
    // If one radius of an ellipse is missing or "auto", it equals the other radius.
    const bool lacks_x = !is_circle && (properties_.find("rx").empty() || properties_.find("rx") == "auto");
    const bool lacks_y = !is_circle && (properties_.find("ry").empty() || properties_.find("ry") == "auto");
    const double rx = lacks_x ? given_y : given_x;
    const double ry = lacks_y ? given_x : given_y;
    if (!(rx > 0) || !(ry > 0)) return {};
    const Point2 center{length_or("cx", Axis::X, measure, 0), length_or("cy", Axis::Y, measure, 0)};
    return {{beziers_of(Arc{center, {Point2{rx, 0}, Point2{0, ry}}, 0, 2 * std::numbers::pi}), true}};
}

/// The outline of a rectangle, rounded if it has rx or ry. A missing radius equals the other radius, and no
/// radius exceeds half of the side.
std::vector<Subpath> SvgElement::rectangle(const SvgMeasure& measure) const {
    const double width = size_or("width", Axis::X, measure, 0);
    const double height = size_or("height", Axis::Y, measure, 0);
    if (!(width > 0) || !(height > 0)) return {};
    const double given_x = length_or("rx", Axis::X, measure, length_or("ry", Axis::Y, measure, 0));
    const double given_y = length_or("ry", Axis::Y, measure, length_or("rx", Axis::X, measure, 0));
    const double rx = std::clamp(given_x, 0.0, width / 2);
    const double ry = std::clamp(given_y, 0.0, height / 2);
    const double x = length_or("x", Axis::X, measure, 0);
    const double y = length_or("y", Axis::Y, measure, 0);
    const std::array<Point2, 4> centers = {Point2{x + width - rx, y + height - ry},
                                           Point2{x + rx, y + height - ry}, Point2{x + rx, y + ry},
                                           Point2{x + width - rx, y + ry}};
    Subpath subpath{{}, true};
    for (std::size_t i = 0; i < 4; ++i) {
        const double quarter = std::numbers::pi / 2;
        const auto corner = beziers_of(
            Arc{centers[i], {Point2{rx, 0}, Point2{0, ry}}, quarter * static_cast<double>(i), quarter});
        if (i > 0) subpath.pieces.push_back(straight(subpath.pieces.back()[3], corner.front()[0]));
        subpath.pieces.insert(subpath.pieces.end(), corner.begin(), corner.end());
    }
    return {subpath};
}

Subpath SvgBox::outline() const {
    const std::array<Point2, 4> corners = {Point2{x, y}, Point2{x + width, y}, Point2{x + width, y + height},
                                           Point2{x, y + height}};
    Subpath subpath{{}, true};
    for (std::size_t i = 0; i < 4; ++i) subpath.pieces.push_back(straight(corners[i], corners[(i + 1) % 4]));
    return subpath;
}

Affine map_of_view_box(const std::array<double, 4>& view_box, const SvgBox& shown,
                       std::string_view preserve_aspect_ratio) {
    double scale_x = shown.width / view_box[2];
    double scale_y = shown.height / view_box[3];
    if (preserve_aspect_ratio.find("none") == std::string_view::npos) {
        const bool is_slice = preserve_aspect_ratio.find("slice") != std::string_view::npos;
        scale_x = scale_y = is_slice ? std::max(scale_x, scale_y) : std::min(scale_x, scale_y);
    }
    const double x =
        shown.x + share_before(preserve_aspect_ratio, "x") * (shown.width - scale_x * view_box[2]);
    const double y =
        shown.y + share_before(preserve_aspect_ratio, "Y") * (shown.height - scale_y * view_box[3]);
    return {scale_x, 0, 0, scale_y, x - scale_x * view_box[0], y - scale_y * view_box[1]};
}

}  // namespace fretwork::outlines::detail
