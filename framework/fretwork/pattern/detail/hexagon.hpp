// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/detail/exact_geometry.hpp>

#include <array>
#include <vector>

namespace fretwork::pattern::detail {

/// The scalar product, in the regular hexagon of side 1, of two vectors in affine coordinates of the base
/// triangle. The product is rational, because v0 v1 and v0 v2 have length 1 and enclose 60 degrees.
inline ExactNumber hexagon_dot(const ExactVector& a, const ExactVector& b) {
    return a.x() * b.x() + a.y() * b.y() + (a.x() * b.y() + a.y() * b.x()) / 2;
}

/// The point turned by one sector about v0: v1 goes to v2, and v2 to v2 - v1.
inline ExactPoint next_sector(const ExactPoint& point) {
    return {-point.y(), point.x() + point.y()};
}

/// One copy of a candidate edge in the reference fan.
struct PlacedEdge {
    EdgeIndex edge;
    int sector = 0;
    std::array<int, 2> fan_nodes{};      ///< numbers of the ends; equal numbers mean the same node of the fan
    std::array<ExactPoint, 2> points{};  ///< places of the ends, in the coordinates of sector 0
};

/// Every copy of every candidate edge in the reference fan, sector by sector.
std::vector<PlacedEdge> place_candidates_in_hexagon(const NodeLayout& layout);

}  // namespace fretwork::pattern::detail
