// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/polygon.hpp>

#include <set>
#include <vector>

namespace fretwork::tiling::detail {

/// A closed polyline by its arc length: from 0 at its first point to length() at the same point again.
class ClosedCurve {
  public:
    explicit ClosedCurve(pattern::Polygon points);

    [[nodiscard]] double length() const { return starts_.back(); }
    /// The point at a place along the curve; any number, since the curve is closed.
    [[nodiscard]] pattern::Point2 at(double place) const;
    /// The point of the curve nearest to `point`.
    [[nodiscard]] pattern::Point2 nearest(pattern::Point2 point) const;
    /// The places of its corners, ascending: where the curve turns by more than `smallest_turn` (rad, either
    /// way) within `reach` (metres) to both sides; one corner in each stretch of that length.
    [[nodiscard]] std::vector<double> corners(double reach, double smallest_turn) const;

  private:
    [[nodiscard]] double turn_at(double place, double reach) const;
    [[nodiscard]] bool has_place_within(const std::set<double>& places, double place, double reach) const;

    pattern::Polygon points_;
    std::vector<double> starts_;  // arc length at each point, and at the first again

    /// Sides first .. last - 1; none of their points is farther from `middle` (on them) than half_length.
    struct Stretch {
        pattern::Point2 middle;
        double half_length;
        std::size_t first;
        std::size_t last;
    };
    std::vector<Stretch> stretches_;
};

}  // namespace fretwork::tiling::detail
