// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/winding.hpp>
#include <fretwork/outlines/svg/shown.hpp>

#include <algorithm>
#include <array>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

bool is_near_edge(const FilledShape& shape, Point2 point, double margin) {
    for (const Polygon& loop : shape.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point2 from = loop[i];
            const Point2 to = loop[(i + 1) % loop.size()];
            if (from != to && distance(point, nearest_on_segment(from, to, point)) <= margin) return true;
        }
    }
    return false;
}

/// True if two points lie on different sides of a line, each farther from it than a margin.
bool are_parted(Point2 from, Point2 to, std::array<Point2, 2> points, double margin) {
    const double least = margin * distance(from, to);
    const double first = cross(to - from, points[0] - from);
    const double second = cross(to - from, points[1] - from);
    return std::min(first, second) < -least && std::max(first, second) > least;
}

bool crosses_edge(const FilledShape& shape, std::array<Point2, 2> side, double margin) {
    for (const Polygon& loop : shape.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::array<Point2, 2> edge = {loop[i], loop[(i + 1) % loop.size()]};
            if (are_parted(edge[0], edge[1], side, margin) && are_parted(side[0], side[1], edge, margin))
                return true;
        }
    }
    return false;
}

bool is_whole_in(const Picture& picture, const FilledShape& shape, const Polygon& line, double margin) {
    for (const Point2 point : line)
        if (!is_filled_at(shape, point) && !is_near_edge(shape, point, margin)) return false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if (crosses_edge(shape, {line[i], line[i + 1]}, margin)) return false;
    return is_shown_whole(picture, shape.clip, line, margin);
}

}  // namespace

bool is_filled_at(const FilledShape& shape, Point2 point) {
    int winding = 0;
    for (const Polygon& loop : shape.loops) winding += winding_number(loop, point);
    return shape.rule == FillRule::Nonzero ? winding != 0 : winding % 2 != 0;
}

bool is_shown_at(const Picture& picture, std::optional<std::size_t> clip, Point2 point) {
    while (clip) {
        const Clip& now = picture.clips[*clip];
        const auto shows = [&](const FilledShape& shape) {
            return is_filled_at(shape, point) && is_shown_at(picture, shape.clip, point);
        };
        if (std::ranges::none_of(now.shapes, shows)) return false;
        clip = now.outer;
    }
    return true;
}

bool is_shown_whole(const Picture& picture, std::optional<std::size_t> clip, const Polygon& line,
                    double margin) {
    while (clip) {
        const Clip& now = picture.clips[*clip];
        const auto is_in = [&](const FilledShape& shape) {
            return is_whole_in(picture, shape, line, margin);
        };
        if (std::ranges::none_of(now.shapes, is_in)) return false;
        clip = now.outer;
    }
    return true;
}

}  // namespace fretwork::outlines::detail
