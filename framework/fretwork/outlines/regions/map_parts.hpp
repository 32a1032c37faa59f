// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/box.hpp>
#include <fretwork/outlines/regions/filled_region.hpp>
#include <fretwork/outlines/regions/planar_map.hpp>

#include <vector>

namespace fretwork::outlines::detail {

/// The parts of a map. Filled faces that share a side belong to the same part. A part that touches itself at
/// a point is opened at that point by `tolerance` (m), so that every part is an outline. Parts narrower than
/// `tolerance` are left out. Throws GeometryError if curves cross at places too near to each other, and as
/// make_line_map().
Region region_of_map(LineMap& lines, double tolerance);

/// The points along a closed chain of halfedges.
geometry::Polygon polygon_around(PlanarMap::Ccb_halfedge_const_circulator first);

/// The smallest box around all polygons; zero if there are no points.
geometry::Box box_of(const std::vector<geometry::Polygon>& polygons);

}  // namespace fretwork::outlines::detail
