// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/plane.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace fretwork::tiling::detail {

/// Finds sites near a place.
class SiteGrid {
  public:
    explicit SiteGrid(double width) : grid_(width) {}
    void add(geometry::Point2 site) { cells_[key(index(site.x), index(site.y))].push_back(site); }
    /// Whether a site is nearer to the place than `reach`, which is no more than the cells' width.
    [[nodiscard]] bool has_near(geometry::Point2 place, double reach) const {
        for (int column = index(place.x) - 1; column <= index(place.x) + 1; ++column) {
            for (int row = index(place.y) - 1; row <= index(place.y) + 1; ++row) {
                const auto found = cells_.find(key(column, row));
                if (found == cells_.end()) continue;
                for (const geometry::Point2& site : found->second) {
                    if (distance(site, place) < reach) return true;
                }
            }
        }
        return false;
    }

  private:
    [[nodiscard]] int index(double x) const { return static_cast<int>(std::floor(x / grid_)); }
    [[nodiscard]] static std::uint64_t key(int column, int row) {
        return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32U) |
               static_cast<std::uint32_t>(row);
    }
    double grid_;
    std::unordered_map<std::uint64_t, std::vector<geometry::Point2>> cells_;
};

}  // namespace fretwork::tiling::detail
