// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/svg/svg_text.hpp>

#include <numbers>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;

/// An arc in SVG's endpoint form.
struct EndpointArc {
    Point2 from;
    Point2 to;
    double rx;
    double ry;
    double rotation;  // rad
    bool is_large;
    bool is_positive;
};

/// From endpoints to center (SVG 1.1, appendix F.6).
std::vector<Bezier> beziers_of(const EndpointArc& arc) {
    double rx = std::abs(arc.rx);
    double ry = std::abs(arc.ry);
    if (rx == 0 || ry == 0) return {straight(arc.from, arc.to)};
    const Point2 x_axis{std::cos(arc.rotation), std::sin(arc.rotation)};
    const Point2 y_axis{-x_axis.y, x_axis.x};
    const Point2 half = 0.5 * (arc.from - arc.to);
    // In coordinates in which the ellipse is the unit circle.
    Point2 start{dot(half, x_axis) / rx, dot(half, y_axis) / ry};
    if (const double reach = length(start); reach > 1) {  // radii too small to reach the end are enlarged
        rx *= reach;
        ry *= reach;
        start = (1 / reach) * start;
    }
    const double off =
        std::sqrt(std::max(0.0, 1 / dot(start, start) - 1)) * (arc.is_large == arc.is_positive ? -1 : 1);
    const Point2 center{off * start.y, -off * start.x};
    const Point2 to_start = start - center;
    const Point2 to_end = -1.0 * start - center;
    double sweep = turn(to_start, to_end);
    if (arc.is_positive && sweep < 0) sweep += 2 * std::numbers::pi;
    if (!arc.is_positive && sweep > 0) sweep -= 2 * std::numbers::pi;
    const Point2 place = 0.5 * (arc.from + arc.to) + (center.x * rx) * x_axis + (center.y * ry) * y_axis;
    auto curves =
        beziers_of(Arc{place, {rx * x_axis, ry * y_axis}, std::atan2(to_start.y, to_start.x), sweep});
    curves.front().front() = arc.from;
    curves.back().back() = arc.to;
    return curves;
}

class PathParser {
  public:
    explicit PathParser(std::string_view text) : text_(text) {}

    std::vector<Subpath> run() {
        char command = 0;
        while (!text_.at_end()) {
            const bool repeats = command != 0 && text_.at_number();
            if (!repeats) {
                command = text_.letter();
            } else if (command == 'M' || command == 'm') {
                command = command == 'M' ? 'L' : 'l';  // further points of a moveto mean lines
            } else if (command == 'Z' || command == 'z') {
                text_.fail("a command is expected");
            }
            if (!has_begun_ && command != 'M' && command != 'm') text_.fail("a path begins with M or m");
            is_relative_ = command >= 'a';
            execute(is_relative_ ? static_cast<char>(command - 'a' + 'A') : command);
        }
        std::erase_if(subpaths_, [](const Subpath& subpath) { return subpath.pieces.empty(); });
        return std::move(subpaths_);
    }

  private:
    void execute(char command) {
        const char before = last_;
        last_ = command;
        switch (command) {
            case 'M':
                return move_to(point());
            case 'L':
                return line_to(point());
            case 'H':
                return line_to({(is_relative_ ? here_.x : 0) + text_.number(), here_.y});
            case 'V':
                return line_to({here_.x, (is_relative_ ? here_.y : 0) + text_.number()});
            case 'C': {
                const Point2 first = point();
                const Point2 second = point();
                return cubic_to(first, second, point());
            }
            case 'S': {
                const Point2 first = before == 'C' || before == 'S' ? 2.0 * here_ - handle_ : here_;
                const Point2 second = point();
                return cubic_to(first, second, point());
            }
            case 'Q': {
                const Point2 handle = point();
                return quadratic_to(handle, point());
            }
            case 'T': {
                const Point2 handle = before == 'Q' || before == 'T' ? 2.0 * here_ - handle_ : here_;
                return quadratic_to(handle, point());
            }
            case 'A':
                return arc_to();
            case 'Z':
                return close();
            default:
                text_.fail(std::string("'") + command +
                           "' is not a command of a path: expected one of M L H V C S Q T A Z");
        }
    }

    Point2 point() {
        const double x = text_.number();
        const Point2 given{x, text_.number()};
        return is_relative_ ? here_ + given : given;
    }

    void move_to(Point2 place) {
        has_begun_ = true;
        here_ = start_ = place;
        subpaths_.emplace_back();
    }
    void add(const Bezier& piece) {
        if (++pieces_ > kMostPieces)
            text_.fail("more than " + std::to_string(kMostPieces) +
                       " pieces of a path are more than an outline can use;");
        if (subpaths_.back().is_closed) subpaths_.emplace_back();  // drawing continues after Z
        subpaths_.back().pieces.push_back(piece);
        here_ = piece[3];
    }
    void line_to(Point2 place) { add(straight(here_, place)); }
    void cubic_to(Point2 first, Point2 second, Point2 place) {
        handle_ = second;
        add({here_, first, second, place});
    }
    void quadratic_to(Point2 handle, Point2 place) {
        handle_ = handle;
        add({here_, between(here_, handle, 2.0 / 3), between(place, handle, 2.0 / 3), place});
    }
    void arc_to() {
        EndpointArc arc{};
        arc.from = here_;
        arc.rx = text_.number();
        arc.ry = text_.number();
        arc.rotation = text_.number() * std::numbers::pi / 180;
        arc.is_large = text_.flag();
        arc.is_positive = text_.flag();
        arc.to = point();
        if (arc.to == arc.from) return;
        for (const Bezier& piece : beziers_of(arc)) add(piece);
    }
    void close() {
        subpaths_.back().is_closed = true;
        here_ = start_;
    }

    static constexpr int kMostPieces = 200'000;

    SvgText text_;
    int pieces_ = 0;
    std::vector<Subpath> subpaths_;
    Point2 here_;
    Point2 start_;
    Point2 handle_;  // the last control point, which S and T reflect
    char last_ = 0;
    bool is_relative_ = false;
    bool has_begun_ = false;
};

}  // namespace

std::vector<Subpath> parse_svg_path(std::string_view text) {
    return PathParser(text).run();
}

}  // namespace fretwork::outlines::detail
