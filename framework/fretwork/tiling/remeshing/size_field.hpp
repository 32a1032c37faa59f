// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace fretwork::tiling::detail {

/// The wanted side of the tiles at each place. The wanted side is uniform except near places with a limit.
/// From such a place, the wanted side grows by kGrowth times the distance, up to the uniform side, so that
/// neighbouring tiles differ little.
class SizeField {
  public:
    static constexpr double kGrowth = 0.4;

    /// @param side  the wanted side far from all limits, m
    explicit SizeField(double side) : side_(side), smallest_(side) {}

    /// The wanted side at a place, m.
    [[nodiscard]] double at(geometry::Point2 place) const;
    /// Limit the side at a place to `side` (m). The limit is dropped if the side there is at most 1.2 times
    /// `side`. Returns true if the limit is kept.
    bool limit(geometry::Point2 place, double side);

    [[nodiscard]] double largest() const { return side_; }
    /// The smallest wanted side: the smallest limit or, without limits, the uniform side, m.
    [[nodiscard]] double smallest() const { return smallest_; }
    [[nodiscard]] bool is_uniform() const { return cells_.empty(); }

    /// A square in which some limit may reduce the side.
    struct Square {
        geometry::Point2 middle;
        double half_width;
    };
    [[nodiscard]] std::vector<Square> limited_squares() const;

  private:
    struct Limit {
        geometry::Point2 place;
        double side;
    };
    using Cell = std::uint64_t;  // column and row of a square grid
    [[nodiscard]] Cell cell(std::int32_t column, std::int32_t row) const;
    [[nodiscard]] std::int32_t index(double coordinate) const;

    double side_;
    double smallest_;
    std::unordered_map<Cell, std::vector<Limit>> cells_;  // the limits that reduce the side in a cell
};

/// The wanted distance of neighbouring sites, as a multiple of the wanted side of the tiles at the same
/// place.
struct Spacing {
    const SizeField& field;
    double factor;  ///< distance over side; sqrt(3) for regular hexagons
    [[nodiscard]] double at(geometry::Point2 place) const { return factor * field.at(place); }
    [[nodiscard]] double largest() const { return factor * field.largest(); }
};

}  // namespace fretwork::tiling::detail
