// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <functional>
#include <set>
#include <span>
#include <vector>

namespace fretwork::tiling::detail {

/// A closed polyline, parametrized by arc length (m): a place on the curve is a number from 0 at the first
/// point to length(), which is the first point again.
class ClosedCurve {
  public:
    explicit ClosedCurve(geometry::Polygon points);

    [[nodiscard]] double length() const { return starts_.back(); }
    /// The point at a place. The place may be any number, because the curve is closed.
    [[nodiscard]] geometry::Point2 at(double place) const;
    /// The distance forward from one place to another, from 0 to less than length().
    [[nodiscard]] double way(double from, double to) const;
    /// The place nearest to `point` on the way forward from `from` to `to`.
    [[nodiscard]] double nearest_between(double from, double to, geometry::Point2 point) const;
    /// The points of the curve between two places, both ends included.
    [[nodiscard]] geometry::Polygon stretch(double from, double to) const;
    /// The places of the corners, ascending. At a corner, the curve turns by more than `smallest_turn` (rad,
    /// left or right) within the distance reach(point) (m) before and after it. If two corners are nearer to
    /// each other than twice this distance, only the sharper corner is listed.
    [[nodiscard]] std::vector<double> corners(const std::function<double(geometry::Point2)>& reach,
                                              double smallest_turn) const;

  private:
    /// The side on which a place within one turn of the curve lies.
    [[nodiscard]] std::size_t side_of(double place) const;
    [[nodiscard]] double turn_at(double place, double reach) const;
    [[nodiscard]] bool has_place_within(const std::set<double>& places, double place, double reach) const;

    geometry::Polygon points_;
    // Arc length at each point, and after the last side at the first point again.
    std::vector<double> starts_;
};

}  // namespace fretwork::tiling::detail
