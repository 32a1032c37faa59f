// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/plane.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace fretwork::geometry {

/// A grid that finds the points near a place. Its cells are squares as wide as the search distance, so a
/// point within that distance lies in the place's cell or in one of the eight cells around it. Adding and
/// searching take constant time if few points share a cell.
class PointGrid {
  public:
    /// Make an empty grid.
    /// @param width  the largest distance at which points are found, m, above zero
    explicit PointGrid(double width) : width_(width) {}

    /// Add a point. Points are numbered in the order in which they are added.
    /// @return the number of this point
    std::size_t add(Point2 point) {
        cells_[cell(point)].push_back(points_.size());
        points_.push_back(point);
        return points_.size() - 1;
    }
    /// All points, in the order in which they were added.
    [[nodiscard]] const std::vector<Point2>& points() const { return points_; }

    /// Call `visit(number)` for each point in a place's cell and the eight cells around it, in an unspecified
    /// order, until one call returns true.
    /// @return true if a call returned true
    template <class Visit>
    bool any_around(Point2 place, Visit visit) const {
        const Cell middle = cell(place);
        for (std::int64_t x = middle.x - 1; x <= middle.x + 1; ++x) {
            for (std::int64_t y = middle.y - 1; y <= middle.y + 1; ++y) {
                const auto found = cells_.find({x, y});
                if (found == cells_.end()) continue;
                for (const std::size_t number : found->second)
                    if (visit(number)) return true;
            }
        }
        return false;
    }

    /// Call `visit(number)` for each point in a place's cell and the eight cells around it.
    template <class Visit>
    void visit_around(Point2 place, Visit visit) const {
        any_around(place, [&](std::size_t number) {
            visit(number);
            return false;
        });
    }

    /// True if a point is nearer to `place` than `reach`. Pre: `reach` is at most the width of a cell.
    [[nodiscard]] bool has_near(Point2 place, double reach) const {
        return any_around(place,
                          [&](std::size_t number) { return distance(points_[number], place) < reach; });
    }

    /// The smallest number of a point at most `reach` away from `point`. Adds `point` if there is no such
    /// point. Pre: `reach` is at most the width of a cell.
    std::size_t number_of(Point2 point, double reach) {
        std::optional<std::size_t> found;
        visit_around(point, [&](std::size_t other) {
            if (distance(points_[other], point) <= reach && (!found || other < *found)) found = other;
        });
        return found ? *found : add(point);
    }

  private:
    struct Cell {
        std::int64_t x;
        std::int64_t y;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    struct Hash {
        std::size_t operator()(const Cell& cell) const {
            return static_cast<std::uint64_t>(cell.x) * 73'856'093U ^
                   static_cast<std::uint64_t>(cell.y) * 19'349'663U;
        }
    };
    [[nodiscard]] Cell cell(Point2 point) const { return {number(point.x), number(point.y)}; }
    /// Beyond 2^53 cells only neighbouring doubles are near each other: their bits give their number.
    [[nodiscard]] std::int64_t number(double coordinate) const {
        constexpr double kMost = 0x1p53;
        const double cell = std::floor(coordinate / width_);
        return std::abs(cell) < kMost ? static_cast<std::int64_t>(cell)
                                      : std::bit_cast<std::int64_t>(coordinate) / 2;
    }

    double width_;
    std::vector<Point2> points_;
    std::unordered_map<Cell, std::vector<std::size_t>, Hash> cells_;
};

}  // namespace fretwork::geometry
