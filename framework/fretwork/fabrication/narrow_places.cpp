// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>
#include <fretwork/fabrication/detail/assembling.hpp>
#include <fretwork/fabrication/narrow_places.hpp>
#include <fretwork/geometry/box_grid.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>
#include <tuple>

namespace fretwork::fabrication {
namespace {

using geometry::Box;
using geometry::Point2;

using namespace detail;
using geometry::Polygon;

constexpr double kChordTolerance = 2e-5;  // m

double distance_to_rim(const Polygon& polygon, const Point2& point) {
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 foot = nearest_on_segment(polygon[i], polygon[(i + 1) % polygon.size()], point);
        nearest = std::min(nearest, distance(point, foot));
    }
    return contains(polygon, point) ? nearest : -nearest;
}

/// A square that may hold the center of the largest circle.
struct Cell {
    Point2 center;
    double half = 0.0;
    double depth = 0.0;  ///< distance of the center to the rim, negative outside
    [[nodiscard]] double most() const { return depth + half * std::numbers::sqrt2; }
    bool operator<(const Cell& other) const { return most() < other.most(); }
};

/// A corner of the material, or a place on its arcs, that points into empty space.
struct Tip {
    Point2 place;
    Point2 in;   ///< direction of the contour before the tip
    Point2 out;  ///< direction of the contour after the tip
};

/// Finds the gaps between all contours of a shape.
class ThroatFinder {
  public:
    ThroatFinder(const Shape& shape, double reach) : reach_(reach) {
        for (const Piece& piece : shape.pieces) {
            add(flattened(piece.outer, kChordTolerance));
            for (const Contour& opening : piece.openings) add(flattened(opening, kChordTolerance));
        }
    }

    [[nodiscard]] std::vector<NarrowPlace> run(const base::Control& control) const {
        std::vector<Box> boxes;
        for (const Edge& edge : edges_) boxes.push_back(box_of(std::array{edge.from, edge.to}));
        const geometry::BoxGrid grid(boxes);
        std::vector<std::optional<NarrowPlace>> found(tips_.size());
        base::parallel_for(tips_.size(), 0, [&](std::size_t t) {
            control.check();
            const Point2& place = tips_[t].place;
            const Box around = geometry::grown({place.x, place.y, place.x, place.y}, reach_);
            for (const std::size_t e : grid.meeting(around)) consider(tips_[t], edges_[e], found[t]);
        });
        std::vector<NarrowPlace> throats;
        for (const auto& one : found)
            if (one) throats.push_back(*one);
        return throats;
    }

  private:
    struct Edge {
        Point2 from;
        Point2 to;
    };

    void add(const Polygon& polygon) {
        const std::size_t count = polygon.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Point2& before = polygon[(i + count - 1) % count];
            const Point2& after = polygon[(i + 1) % count];
            edges_.push_back({polygon[i], after});
            const Tip tip{polygon[i], unit(polygon[i] - before), unit(after - polygon[i])};
            if (cross(tip.in, tip.out) > kLeastTurn) tips_.push_back(tip);
        }
    }

    /// True if no step along the contour from the tip comes nearer to a point in the direction `to`.
    static bool points_at(const Tip& tip, const Point2& to) {
        constexpr double kRightAngle = 1e-6;
        return dot(to, tip.in) >= -kRightAngle && dot(to, tip.out) <= kRightAngle;
    }

    void consider(const Tip& tip, const Edge& edge, std::optional<NarrowPlace>& narrowest) const {
        const Point2 along = edge.to - edge.from;
        if (cross(along, tip.place - edge.from) >= 0.0) return;  // the tip is not on the empty side
        const double share = dot(tip.place - edge.from, along) / dot(along, along);
        if (share < 0.0 || share > 1.0) return;
        const Point2 foot = edge.from + share * along;
        const double gap = distance(tip.place, foot);
        if (gap == 0.0 || gap > reach_ || (narrowest && narrowest->width <= gap)) return;
        if (!points_at(tip, unit(foot - tip.place))) return;
        narrowest = NarrowPlace{NarrowPlace::Kind::Gap, 0.5 * (tip.place + foot), gap, {}, {}};
    }

    static constexpr double kLeastTurn = 1e-4;
    double reach_;
    std::vector<Edge> edges_;
    std::vector<Tip> tips_;
};

/// Openings whose largest inner circle has a diameter below `clearance`.
std::vector<NarrowPlace> narrow_openings(const Shape& shape, double clearance, const base::Control& control) {
    std::vector<const Contour*> openings;
    for (const Piece& piece : shape.pieces)
        for (const Contour& opening : piece.openings) openings.push_back(&opening);
    std::vector<std::optional<NarrowPlace>> found(openings.size());
    base::parallel_for(openings.size(), 0, [&](std::size_t i) {
        control.check();
        const InnerCircle circle = inner_circle(flattened(*openings[i], kChordTolerance));
        if (2.0 * circle.radius < clearance)
            found[i] = NarrowPlace{NarrowPlace::Kind::Opening, circle.center, 2.0 * circle.radius, {}, {}};
    });
    std::vector<NarrowPlace> narrow;
    for (const auto& one : found)
        if (one) narrow.push_back(*one);
    return narrow;
}

/// Set the nearest bar's tile and the nearest node.
void name_places(std::vector<NarrowPlace>& places, const BarPlan& plan, const base::Control& control) {
    if (places.empty()) return;
    std::vector<Box> boxes;
    const auto end = [&](const Bar& bar, std::size_t i) { return plan.nodes[bar.nodes[i]]; };
    for (const Bar& bar : plan.bars) boxes.push_back(box_of(std::array{end(bar, 0), end(bar, 1)}));
    const geometry::BoxGrid grid(boxes);
    for (NarrowPlace& narrow : places) {
        control.check();
        const Point2& p = narrow.place;
        double nearest = std::numeric_limits<double>::max();
        double nearest_node = nearest;
        const auto look_at = [&](const Bar& bar) {
            const double to_bar = distance(p, nearest_on_segment(end(bar, 0), end(bar, 1), p));
            if (to_bar < nearest) {
                nearest = to_bar;
                narrow.tile = bar.tile;
            }
            for (std::size_t i = 0; i < 2; ++i) {
                if (distance(p, end(bar, i)) >= nearest_node) continue;
                nearest_node = distance(p, end(bar, i));
                narrow.node = bar.nodes[i];
            }
        };
        // The lines of frames, which are wide, may be far from the place.
        for (double reach = narrow.width + 2.0 * plan.width; nearest > reach; reach *= 2.0)
            for (const std::size_t b : grid.meeting(geometry::grown({p.x, p.y, p.x, p.y}, reach)))
                look_at(plan.bars[b]);
    }
}

}  // namespace

InnerCircle inner_circle(const Polygon& polygon) {
    const Box box = geometry::box_of(std::span<const Point2>(polygon));
    const double half = 0.5 * std::min(box.width(), box.height());
    const auto cell = [&](const Point2& center, double size) {
        return Cell{center, size, distance_to_rim(polygon, center)};
    };
    Cell best = cell(box.middle(), 0.0);
    if (!(half > 0.0)) return {best.center, 0.0};  // flat: no square covers it
    std::priority_queue<Cell> cells;
    for (double x = box.xmin + half; x < box.xmax + half; x += 2.0 * half)
        for (double y = box.ymin + half; y < box.ymax + half; y += 2.0 * half) cells.push(cell({x, y}, half));
    constexpr double kPrecision = 0.01;
    constexpr double kLeast = 1e-8;  // m
    while (!cells.empty()) {
        const Cell next = cells.top();
        cells.pop();
        if (next.depth > best.depth) best = next;
        if (next.most() - best.depth <= std::max(kLeast, kPrecision * best.depth)) break;
        const double quarter = 0.5 * next.half;
        for (const double dx : {-quarter, quarter})
            for (const double dy : {-quarter, quarter})
                cells.push(cell({next.center.x + dx, next.center.y + dy}, quarter));
    }
    return {best.center, std::max(0.0, best.depth)};
}

std::vector<NarrowPlace> narrow_places(const Shape& shape, const BarPlan& plan, double clearance,
                                       const base::Control& control) {
    std::vector<NarrowPlace> places = narrow_openings(shape, clearance, control);
    for (NarrowPlace& throat : ThroatFinder(shape, clearance).run(control))
        if (throat.width < clearance) places.push_back(throat);
    std::ranges::sort(places, {}, [](const NarrowPlace& place) {
        return std::tuple(place.width, place.place.x, place.place.y);
    });
    name_places(places, plan, control);
    return places;
}

}  // namespace fretwork::fabrication
