// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/box_grid.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/outline_check.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace fretwork::outlines {
namespace {

using geometry::Point2;
using geometry::Polygon;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ExactPoint = Kernel::Point_2;

std::string loop_name(std::size_t loop) {
    return loop == 0 ? "the boundary" : "hole " + std::to_string(loop - 1);
}

std::string text(const ExactPoint& point) {
    return "(" + base::format_number(point.x()) + ", " + base::format_number(point.y()) + ")";
}

/// A side of the outline, for messages and tests.
struct Side {
    std::size_t loop;
    std::size_t index;  // index of its first point
    std::size_t count;  // number of sides of its loop
    ExactPoint from;
    ExactPoint to;

    [[nodiscard]] std::string name() const {
        return "side " + std::to_string(index) + " of " + loop_name(loop) + ", from " + text(from) + " to " +
               text(to);
    }
    [[nodiscard]] bool is_followed_by(const Side& other) const {
        return loop == other.loop && (index + 1) % count == other.index;
    }
};

std::vector<Side> sides_of(const std::vector<Polygon>& loops) {
    std::vector<Side> sides;
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        const Polygon& points = loops[loop];
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point2& next = points[(i + 1) % points.size()];
            sides.push_back({loop, i, points.size(), {points[i].x, points[i].y}, {next.x, next.y}});
        }
    }
    return sides;
}

std::optional<std::string> flaw_of_points(const std::vector<Polygon>& loops) {
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        if (loops[loop].size() < 3) {
            return (loop_name(loop) + " has " + std::to_string(loops[loop].size()) +
                    " points, where at least 3 are needed");
        }
        for (std::size_t i = 0; i < loops[loop].size(); ++i) {
            const Point2& point = loops[loop][i];
            if (!std::isfinite(point.x) || !std::isfinite(point.y))
                return ("point " + std::to_string(i) + " of " + loop_name(loop) + " is not finite");
            if (point == loops[loop][(i + 1) % loops[loop].size()])
                return ("side " + std::to_string(i) + " of " + loop_name(loop) + " at " +
                        text({point.x, point.y}) + " has no length");
        }
    }
    return std::nullopt;
}

/// True if two sides have a point in common, other than the common end of neighbouring sides.
bool clash(const Side& a, const Side& b) {
    const auto folds_back = [](const Side& first, const Side& second) {
        return CGAL::collinear(first.from, first.to, second.to) &&
               !CGAL::collinear_are_strictly_ordered_along_line(first.from, first.to, second.to);
    };
    if (a.is_followed_by(b)) return folds_back(a, b);
    if (b.is_followed_by(a)) return folds_back(b, a);
    return CGAL::do_intersect(Kernel::Segment_2(a.from, a.to), Kernel::Segment_2(b.from, b.to));
}

/// Call found(pair) for each pair of sides that clash. Pairs whose boxes meet are tested exactly.
template <class Found>
void for_each_clash(const std::vector<Side>& sides, const base::Control& control, const Found& found) {
    using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Side*>;
    std::vector<Box> boxes;
    boxes.reserve(sides.size());
    for (const Side& side : sides) boxes.emplace_back(side.from.bbox() + side.to.bbox(), &side);
    std::size_t near = 0;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        control.check();
        const std::pair<const Side*, const Side*> pair = std::minmax(a.handle(), b.handle());
        if (++near > detail::kMostNear)
            throw base::GeometryError("its sides come near each other more than " +
                                      std::to_string(detail::kMostNear) + " times, such as " +
                                      pair.first->name() + ", and " + pair.second->name() +
                                      "; simplify the outline");
        if (clash(*pair.first, *pair.second)) found(pair);
    });
}

/// The first pair of sides that clash, in the order of loops and sides.
std::optional<std::string> flaw_of_crossing(const std::vector<Polygon>& loops, const base::Control& control) {
    const std::vector<Side> sides = sides_of(loops);
    std::optional<std::pair<const Side*, const Side*>> first;
    for_each_clash(sides, control, [&](const auto& pair) {
        if (!first || pair < *first) first = pair;
    });
    if (!first) return std::nullopt;
    return first->first->name() + " touches or crosses " + first->second->name();
}

std::vector<ExactPoint> exact(const Polygon& polygon) {
    std::vector<ExactPoint> points;
    for (const Point2& p : polygon) points.emplace_back(p.x, p.y);
    return points;
}

bool is_inside(const Point2& point, const std::vector<ExactPoint>& polygon) {
    return CGAL::bounded_side_2(polygon.begin(), polygon.end(), ExactPoint(point.x, point.y), Kernel()) ==
           CGAL::ON_BOUNDED_SIDE;
}

std::vector<geometry::Box> boxes_of_holes(const std::vector<Polygon>& loops) {
    std::vector<geometry::Box> boxes;
    for (std::size_t hole = 1; hole < loops.size(); ++hole) boxes.push_back(geometry::box_of(loops[hole]));
    return boxes;
}

/// The nesting of loops whose sides do not meet, so one point of a hole decides for the whole hole. Drawings
/// have thousands of holes, so only holes whose boxes contain this point are tested.
class Nesting {
  public:
    explicit Nesting(const std::vector<Polygon>& loops)
        : loops_(loops), boundary_(exact(loops.front())), holes_(boxes_of_holes(loops)) {}

    [[nodiscard]] bool is_in_boundary(std::size_t hole) const {
        return is_inside(loops_[hole].front(), boundary_);
    }
    /// The first hole that contains a given hole.
    [[nodiscard]] std::optional<std::size_t> hole_around(std::size_t hole) const {
        const Point2 point = loops_[hole].front();
        for (const std::size_t near : holes_.meeting({point.x, point.y, point.x, point.y})) {
            const std::size_t other = near + 1;
            if (other != hole && is_inside(point, exact(loops_[other]))) return other;
        }
        return std::nullopt;
    }

  private:
    const std::vector<Polygon>& loops_;
    std::vector<ExactPoint> boundary_;
    geometry::BoxGrid holes_;
};

std::optional<std::string> flaw_of_nesting(const std::vector<Polygon>& loops, const base::Control& control) {
    const Nesting nesting(loops);
    for (std::size_t hole = 1; hole < loops.size(); ++hole) {
        control.check();
        const Point2& point = loops[hole].front();
        const std::string place = ", at " + text({point.x, point.y});
        if (!nesting.is_in_boundary(hole)) return loop_name(hole) + " lies outside the boundary" + place;
        if (const auto other = nesting.hole_around(hole))
            return loop_name(hole) + " lies inside " + loop_name(*other) + place;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> outline_flaw(const std::vector<Polygon>& loops, const base::Control& control) {
    if (auto flaw = flaw_of_points(loops)) return flaw;
    if (auto flaw = flaw_of_crossing(loops, control)) return flaw;
    return flaw_of_nesting(loops, control);
}

std::vector<Point2> places_of_crossings(const std::vector<Polygon>& loops, const base::Control& control) {
    const std::vector<Side> sides = sides_of(loops);
    std::set<const Side*> clashing;
    for_each_clash(sides, control, [&](const auto& pair) { clashing.insert({pair.first, pair.second}); });
    std::vector<Point2> places;
    for (const Side* side : clashing)
        places.push_back({0.5 * (side->from.x() + side->to.x()), 0.5 * (side->from.y() + side->to.y())});
    if (!places.empty()) return places;
    const Nesting nesting(loops);
    for (std::size_t hole = 1; hole < loops.size(); ++hole) {
        control.check();
        if (!nesting.is_in_boundary(hole) || nesting.hole_around(hole)) places.push_back(loops[hole].front());
    }
    return places;
}

}  // namespace fretwork::outlines
