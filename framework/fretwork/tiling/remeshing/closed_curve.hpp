// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <functional>
#include <set>
#include <span>
#include <vector>

namespace fretwork::tiling::detail {

/// A closed polyline by its arc length: from 0 at its first point to length() at the same point again.
class ClosedCurve {
  public:
    explicit ClosedCurve(geometry::Polygon points);

    [[nodiscard]] double length() const { return starts_.back(); }
    /// The point at a place along the curve; any number, since the curve is closed.
    [[nodiscard]] geometry::Point2 at(double place) const;
    /// How far it is forward from one place to another: from 0 to less than length().
    [[nodiscard]] double way(double from, double to) const;
    /// The place between two places (the second behind the first, or equal) whose point is nearest to
    /// `point`.
    [[nodiscard]] double nearest_between(double from, double to, geometry::Point2 point) const;
    /// The points of the curve between two places, with those at the places.
    [[nodiscard]] geometry::Polygon stretch(double from, double to) const;
    /// The places of its corners, ascending: where the curve turns by more than `smallest_turn` (rad, either
    /// way) within reach(point) (metres) to both sides; one corner in each stretch of that length.
    [[nodiscard]] std::vector<double> corners(const std::function<double(geometry::Point2)>& reach,
                                              double smallest_turn) const;

  private:
    /// The side on which a place within one turn of the curve lies.
    [[nodiscard]] std::size_t side_of(double place) const;
    [[nodiscard]] double turn_at(double place, double reach) const;
    [[nodiscard]] bool has_place_within(const std::set<double>& places, double place, double reach) const;

    geometry::Polygon points_;
    std::vector<double> starts_;  // arc length at each point, and at the first again
};

}  // namespace fretwork::tiling::detail
