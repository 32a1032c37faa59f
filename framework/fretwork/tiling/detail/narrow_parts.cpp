// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/detail/narrow_parts.hpp>
#include <fretwork/tiling/remeshing/triangulation.hpp>

#include <algorithm>
#include <functional>
#include <limits>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

// Distance of points on the boundary, as a share of the width that counts as narrow.
constexpr double kSampling = 0.05;
constexpr double kLeastCut = 1.0;     // smallest area cut off, over the square of the width at the cut
constexpr double kSharpCut = 0.9;     // smallest area of a tip, over the cut's squared length: 31 degrees
constexpr double kStraightCut = 1.2;  // largest length of a cut over the width at the cut
constexpr double kEndless = std::numeric_limits<double>::infinity();

void add_loop(const Polygon& points, LoopIndex loop, double longest, Rim& rim) {
    const PointIndex first(rim.points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point2 from = points[i];
        const Point2 to = points[(i + 1) % points.size()];
        const auto count = std::max(1, static_cast<int>(std::ceil(distance(from, to) / longest)));
        for (int k = 0; k < count; ++k) {
            rim.points.push_back({between(from, to, static_cast<double>(k) / count), loop});
            rim.next.emplace_back(rim.points.size());
        }
    }
    rim.next.back() = first;
}

Rim dense_rim(const outlines::Outline& outline, double longest) {
    Rim rim;
    add_loop(outline.boundary, LoopIndex(0), longest, rim);
    int loop = 0;
    for (const Polygon& hole : outline.holes) add_loop(hole, LoopIndex(++loop), longest, rim);
    return rim;
}

/// The triangles as a graph, with the part that each edge cuts off.
class Cuts {
  public:
    Cuts(const Triangulation& triangulation, const SharedTask& task) : t_(triangulation), task_(task) {
        degrees_.assign(t_.triangles.size(), 0);
        for (std::size_t i = 0; i < t_.triangles.size(); ++i) {
            task_.check();
            areas_.push_back(0.5 * cross(corner(i, 1) - corner(i, 0), corner(i, 2) - corner(i, 0)));
            total_ += areas_.back();
            cut_off_.push_back({kEndless, kEndless, kEndless});
            is_end_.push_back({false, false, false});
            for (const TriangleIndex neighbor : t_.neighbors[i]) degrees_[i] += neighbor.is_valid() ? 1 : 0;
        }
        prune();
    }

    /// The smaller of the areas on both sides of an edge; endless if the edge does not divide the shape.
    [[nodiscard]] double cut_off(std::size_t triangle, std::size_t side) const {
        return cut_off_[triangle][side];
    }
    /// True if the triangle lies on the side that the edge cuts off, which is the smaller side.
    [[nodiscard]] bool is_end(std::size_t triangle, std::size_t side) const {
        return is_end_[triangle][side];
    }
    [[nodiscard]] Point2 corner(std::size_t triangle, std::size_t i) const {
        return t_.points[t_.triangles[triangle][i]];
    }

  private:
    /// Repeatedly remove triangles with a single neighbour.
    void prune() {
        std::vector<std::size_t> ends;
        for (std::size_t i = 0; i < degrees_.size(); ++i) {
            if (degrees_[i] == 1) ends.push_back(i);
        }
        std::vector<bool> is_gone(degrees_.size(), false);
        std::vector<double> area = areas_;
        for (std::size_t at = 0; at < ends.size(); ++at) {
            task_.check();
            const std::size_t i = ends[at];
            if (is_gone[i]) continue;
            is_gone[i] = true;
            for (std::size_t side = 0; side < 3; ++side) {
                const TriangleIndex other = t_.neighbors[i][side];
                if (!other.is_valid() || is_gone[other]) continue;
                const double smaller = std::min(area[i], total_ - area[i]);
                cut_off_[i][side] = smaller;
                is_end_[i][side] = area[i] <= smaller;
                const auto back =
                    std::ranges::find(t_.neighbors[other], TriangleIndex(i)) - t_.neighbors[other].begin();
                cut_off_[other][back] = smaller;
                is_end_[other][back] = area[i] > smaller;
                area[other] += area[i];
                if (--degrees_[other] == 1) ends.push_back(other);
            }
        }
    }

    const Triangulation& t_;
    const SharedTask& task_;
    std::vector<double> areas_;
    std::vector<int> degrees_;
    double total_ = 0.0;
    std::vector<std::array<double, 3>> cut_off_;
    std::vector<std::array<bool, 3>> is_end_;
};

/// The width of the shape at an edge: the smaller of the edge's length and the distance from a tip of its
/// triangle to the triangle's side on the rim.
double width_at(const Triangulation& triangulation, const Cuts& cuts, std::size_t triangle,
                std::size_t side) {
    const Point2 from = cuts.corner(triangle, (side + 1) % 3);
    const Point2 to = cuts.corner(triangle, (side + 2) % 3);
    double width = distance(from, to);
    for (std::size_t i = 0; i < 3; ++i) {
        if (triangulation.neighbors[triangle][i].is_valid()) continue;
        const Point2 a = cuts.corner(triangle, (i + 1) % 3);
        const Point2 b = cuts.corner(triangle, (i + 2) % 3);
        const Point2 tip = cuts.corner(triangle, i);
        width = std::min(width, distance(nearest_on_segment(a, b, tip), tip));
    }
    return width;
}

}  // namespace

std::vector<NarrowPlace> narrow_places(const outlines::Outline& outline, const NarrowLimits& limits,
                                       const base::Control& control) {
    const SharedTask task(control.silent(), "");
    const Triangulation triangulation = triangulate(dense_rim(outline, kSampling * limits.width), {}, task);
    const Cuts cuts(triangulation, task);
    std::vector<NarrowPlace> places;
    for (std::size_t i = 0; i < triangulation.triangles.size(); ++i) {
        task.check();
        for (std::size_t side = 0; side < 3; ++side) {
            if (!triangulation.neighbors[i][side].is_valid()) continue;
            const double width = width_at(triangulation, cuts, i, side);
            if (width >= limits.width) continue;
            if (cuts.cut_off(i, side) < std::max(kLeastCut * width * width, limits.least_area)) continue;
            const Point2 place = between(cuts.corner(i, (side + 1) % 3), cuts.corner(i, (side + 2) % 3), 0.5);
            places.push_back({place, width, cuts.cut_off(i, side)});
        }
    }
    std::ranges::stable_sort(places, {}, &NarrowPlace::width);
    return places;
}

namespace {

/// A cut between two points of the rim. It removes the points after `to` and before `from`.
struct TipCut {
    double area;
    PointIndex from;
    PointIndex to;
};

/// The cuts that blunt tips, the largest first.
std::vector<TipCut> tip_cuts(const Triangulation& triangulation, const Cuts& cuts, double most,
                             const SharedTask& task) {
    std::vector<TipCut> result;
    for (std::size_t i = 0; i < triangulation.triangles.size(); ++i) {
        task.check();
        for (std::size_t side = 0; side < 3; ++side) {
            const double area = cuts.cut_off(i, side);
            if (area > most || !cuts.is_end(i, side)) continue;
            const double length = distance(cuts.corner(i, (side + 1) % 3), cuts.corner(i, (side + 2) % 3));
            if (area < kSharpCut * length * length) continue;
            if (length > kStraightCut * width_at(triangulation, cuts, i, side)) continue;
            result.push_back({area, triangulation.triangles[i][(side + 1) % 3],
                              triangulation.triangles[i][(side + 2) % 3]});
        }
    }
    std::ranges::stable_sort(result, std::greater<>(), &TipCut::area);
    return result;
}

/// The outline through the remaining points of each loop.
outlines::Outline outline_of(const Rim& rim, const std::vector<bool>& is_gone, std::size_t loops) {
    base::IndexVector<LoopIndex, Polygon> polygons(loops);
    for (std::size_t i = 0; i < rim.points.size(); ++i) {
        if (!is_gone[i]) polygons[rim.points[i].loop].push_back(rim.points[i].place);
    }
    return {polygons.front(), {polygons.begin() + 1, polygons.end()}};
}

}  // namespace

BluntOutline blunt(const outlines::Outline& outline, double narrow_width, const BluntLimits& limits,
                   const base::Control& control) {
    const SharedTask task(control.silent(), "");
    const Rim rim = dense_rim(outline, kSampling * narrow_width);
    const Triangulation triangulation = triangulate(rim, {}, task);
    const Cuts cuts(triangulation, task);
    std::vector<bool> is_gone(rim.points.size(), false);
    BluntOutline result{outline, 0.0};
    for (const TipCut& cut : tip_cuts(triangulation, cuts, limits.tip, task)) {
        if (is_gone[cut.from] || is_gone[cut.to] || result.lost_area + cut.area > limits.all) continue;
        result.lost_area += cut.area;
        for (PointIndex i = rim.next[cut.to]; i != cut.from; i = rim.next[i]) is_gone[i] = true;
    }
    if (result.lost_area > 0) result.outline = outline_of(rim, is_gone, outline.holes.size() + 1);
    return result;
}

}  // namespace fretwork::tiling::detail
