// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/regions/filled_region.hpp>
#include <fretwork/outlines/regions/planar_map.hpp>

#include <array>

namespace fretwork::outlines::detail {

/// The parts that the filled faces of a map make: faces that share a side belong together. Where a part
/// touches itself at a point it is opened, so that every part is an outline.
Region region_of_map(LineMap& lines, double tolerance);

/// The points along a closed row of halfedges.
geometry::Polygon polygon_around(PlanarMap::Ccb_halfedge_const_circulator first);

/// The lower left and the upper right corner of polygons; no points: two origins.
std::array<geometry::Point2, 2> box_of(const std::vector<geometry::Polygon>& polygons);

}  // namespace fretwork::outlines::detail
