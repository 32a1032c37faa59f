// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>

#include <algorithm>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;

constexpr double kNegligible = 1.2;  // factor; a limit that changes the side by less is dropped

constexpr double kSlack = 1.0 + 1e-9;  // more than rounding

}  // namespace

SizeField::Cell SizeField::cell(std::int32_t column, std::int32_t row) const {
    return (static_cast<Cell>(static_cast<std::uint32_t>(column)) << 32U) | static_cast<std::uint32_t>(row);
}

/// The index of a coordinate in the grid, whose cells are as wide as the largest side. Places further away
/// than whole numbers reach share the outermost cells.
std::int32_t SizeField::index(double coordinate) const {
    constexpr double kMost = 0x1p30;
    return static_cast<std::int32_t>(std::clamp(std::floor(coordinate / side_), -kMost, kMost));
}

double SizeField::at(Point2 place) const {
    double side = side_;
    const auto found = cells_.find(cell(index(place.x), index(place.y)));
    if (found == cells_.end()) return side;
    for (const Limit& limit : found->second) {
        // Square roots are computed only where they can matter.
        const geometry::Point2 apart = place - limit.place;
        const double reach = (side - limit.side) / kGrowth;
        if (reach <= 0.0 || dot(apart, apart) > kSlack * reach * reach) continue;
        side = std::min(side, limit.side + kGrowth * length(apart));
    }
    return side;
}

bool SizeField::limit(Point2 place, double side) {
    if (at(place) <= kNegligible * side) return false;
    smallest_ = std::min(smallest_, side);
    const double reach = (side_ - side) / kGrowth;
    const double half_diagonal = std::sqrt(0.5) * side_;
    for (std::int32_t column = index(place.x - reach); column <= index(place.x + reach); ++column) {
        for (std::int32_t row = index(place.y - reach); row <= index(place.y + reach); ++row) {
            const Point2 middle{(column + 0.5) * side_, (row + 0.5) * side_};
            if (distance(middle, place) < reach + half_diagonal)
                cells_[cell(column, row)].push_back({place, side});
        }
    }
    return true;
}

std::vector<SizeField::Square> SizeField::limited_squares() const {
    std::vector<Cell> keys;
    for (const auto& [key, limits] : cells_) keys.push_back(key);
    std::sort(keys.begin(), keys.end());  // so that the result does not depend on the order of a hash table
    std::vector<Square> squares;
    for (const Cell key : keys) {
        const auto column = static_cast<std::int32_t>(static_cast<std::uint32_t>(key >> 32U));
        const auto row = static_cast<std::int32_t>(static_cast<std::uint32_t>(key));
        squares.push_back({{(column + 0.5) * side_, (row + 0.5) * side_}, 0.5 * side_});
    }
    return squares;
}

}  // namespace fretwork::tiling::detail
