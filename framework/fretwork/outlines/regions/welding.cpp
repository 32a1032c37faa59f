// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/internal/segment_box.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/regions/welding.hpp>

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// Two sides that enclose a smaller angle at a corner form a slit or a needle for much of their length.
constexpr double kSharpest = 4e-3;  // radians

struct ByPlace {
    bool operator()(Point2 a, Point2 b) const { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }
};

struct LoopSide {
    std::size_t loop;
    std::size_t index;  // index of its first point
    Point2 from;
    Point2 to;
};

/// A corner near a side: its place, and its distance along the side.
struct Beside {
    std::size_t loop;
    std::size_t side;
    double along;
    Point2 corner;
    friend bool operator<(const Beside& a, const Beside& b) {
        return std::tie(a.loop, a.side, a.along, a.corner.x, a.corner.y) <
               std::tie(b.loop, b.side, b.along, b.corner.x, b.corner.y);
    }
};

/// Pairs of corners, and of corners and sides, that are nearer to each other than a width.
struct NearThings {
    /// Each corner with the corner that it becomes, which comes before it by place.
    std::map<Point2, Point2, ByPlace> corners;
    std::set<Beside> beside;
    [[nodiscard]] bool empty() const { return corners.empty() && beside.empty(); }
};

std::vector<LoopSide> loop_sides_of(const std::vector<Polygon*>& loops) {
    std::vector<LoopSide> sides;
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        const Polygon& points = *loops[loop];
        for (std::size_t i = 0; i < points.size(); ++i)
            sides.push_back({loop, i, points[i], points[(i + 1) % points.size()]});
    }
    return sides;
}

/// Record a corner if it is near to a side that does not end at it.
void look(Point2 corner, const LoopSide& side, double width, NearThings& near) {
    if (corner == side.from || corner == side.to) return;
    const Point2 nearest = nearest_on_segment(side.from, side.to, corner);
    if (distance(nearest, corner) >= width) return;
    for (const Point2 end : {side.from, side.to}) {
        if (distance(end, corner) >= width) continue;
        const auto [first, second] = std::minmax(end, corner, ByPlace());
        near.corners.emplace(second, first);
        return;
    }
    near.beside.insert({side.loop, side.index, distance(side.from, nearest), corner});
}

NearThings near_things(const std::vector<Polygon*>& loops, double width) {
    using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const LoopSide*>;
    const std::vector<LoopSide> sides = loop_sides_of(loops);
    std::vector<Box> boxes;
    boxes.reserve(sides.size());
    for (const LoopSide& side : sides)
        boxes.emplace_back(geometry::box_around(side.from, side.to, 0.5 * width), &side);
    NearThings near;
    // Each corner is the start of one side.
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        look(a.handle()->from, *b.handle(), width, near);
        look(b.handle()->from, *a.handle(), width, near);
    });
    // Corners in a row become the first one. In the order of places, an earlier corner is known already.
    for (auto& [corner, first] : near.corners)
        if (const auto known = near.corners.find(first); known != near.corners.end()) first = known->second;
    return near;
}

/// Cut off each sharp corner where its sides are twice `width` apart, or else at the end of the shorter side.
/// A corner stays if its sides are less than `width` apart even there. Returns the number of corners cut off.
int blunt(Polygon& points, double width) {
    Polygon blunted;
    int count = 0;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point2 in = points[i] - points[(i + n - 1) % n];
        const Point2 out = points[(i + 1) % n] - points[i];
        const double angle = std::numbers::pi - std::abs(turn(in, out));
        const double shorter = std::min(length(in), length(out));
        if (angle > kSharpest || angle * shorter < width) {
            blunted.push_back(points[i]);
            continue;
        }
        const double reach = std::min(2 * width / angle, shorter);
        blunted.push_back(points[i] - reach / length(in) * in);
        blunted.push_back(points[i] + reach / length(out) * out);
        ++count;
    }
    points = std::move(blunted);
    return count;
}

/// Merge corners, and leave out ways there and back along one side, which enclose nothing: merged teeth of a
/// saw are thousands of equal sides, each near to each.
void merge_corners(Polygon& points, const std::map<Point2, Point2, ByPlace>& corners) {
    Polygon merged;
    for (const Point2& point : points) {
        const auto to = corners.find(point);
        merged.push_back(to == corners.end() ? point : to->second);
        const std::size_t n = merged.size();
        if (n > 1 && merged[n - 1] == merged[n - 2])
            merged.pop_back();
        else if (n > 2 && merged[n - 1] == merged[n - 3])
            merged.resize(n - 2);
    }
    points = std::move(merged);
    geometry::remove_repeated_points(points, 0.0);
}

void lead_through(std::size_t loop, Polygon& points, const std::set<Beside>& beside) {
    Polygon through;
    auto next = beside.lower_bound({.loop = loop, .side = 0, .along = -1, .corner = {}});
    for (std::size_t side = 0; side < points.size(); ++side) {
        through.push_back(points[side]);
        for (; next != beside.end() && next->loop == loop && next->side == side; ++next)
            through.push_back(next->corner);
    }
    points = std::move(through);
}

}  // namespace

int weld(const std::vector<Polygon*>& loops, double width) {
    int welded = 0;
    for (Polygon* loop : loops) welded += blunt(*loop, width);
    if (near_things(loops, width).empty()) return welded;
    for (Polygon* loop : loops) geometry::remove_repeated_points(*loop, width);
    const auto corners = near_things(loops, width).corners;
    for (Polygon* loop : loops) merge_corners(*loop, corners);
    const auto beside = near_things(loops, width).beside;
    for (std::size_t loop = 0; loop < loops.size(); ++loop) lead_through(loop, *loops[loop], beside);
    return welded + static_cast<int>(corners.size() + beside.size());
}

}  // namespace fretwork::outlines::detail
