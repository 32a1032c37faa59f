// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/plane.hpp>
#include <fretwork/simulation/load_cases/selection.hpp>

#include <algorithm>
#include <limits>

namespace fretwork::simulation::detail {

/// The direction in which the surface ends at a side of its bounding box.
inline geometry::Point2 outward(Side side) {
    switch (side) {
        case Side::Left:
            return {-1.0, 0.0};
        case Side::Right:
            return {1.0, 0.0};
        case Side::Bottom:
            return {0.0, -1.0};
        case Side::Top:
            break;
    }
    return {0.0, 1.0};
}

/// The length of a side of a tile along a side of the bounding box. It is negative or zero if the surface, to
/// the left of the tile's side, does not end there in that direction, as at a corner's other side.
inline double length_along(Side side, geometry::Point2 from, geometry::Point2 to) {
    return geometry::cross(outward(side), to - from);
}

/// The strip along a side of the bounding box of the interface nodes, one mean tile side wide.
class SideStrip {
  public:
    SideStrip(Side side, const tiling::Tessellation& tessellation)
        : outward_(outward(side)), width_(tiling::mean_tile_side(tessellation)) {
        for (const geometry::Point2& node : tessellation.interface_nodes)
            lowest_ = std::min(lowest_, height(node));
    }
    /// True if the strip contains a place.
    [[nodiscard]] bool contains(geometry::Point2 place) const { return height(place) <= lowest_ + width_; }

  private:
    /// The height of a place if the side is below, m.
    [[nodiscard]] double height(geometry::Point2 place) const { return -geometry::dot(outward_, place); }

    geometry::Point2 outward_;
    double width_;
    double lowest_ = std::numeric_limits<double>::infinity();
};

}  // namespace fretwork::simulation::detail
