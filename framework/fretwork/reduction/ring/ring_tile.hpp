// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/geometry/polygon.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/reduction/ring/ring_parameters.hpp>

namespace fretwork::reduction {

/// The frame of a ring with links in a polygon (Section 5.1), without supports and loads.
///
/// Let n be the number of all interface nodes. Nodes 0 .. n-1 are the interface nodes, and nodes n .. 2n-1
/// form the ring. The first n beams are the links (interface node i to ring node i), and n ring beams follow.
/// In the setting's regular polygon, the ring is the polygon of the interface nodes, turned by theta and
/// scaled about the center so that R replaces the apothem. In another polygon, each ring node keeps its
/// barycentric coordinates in its sector. The paper has one interface node on each side, so its ring has as
/// many nodes as the polygon has sides. The material is the setting's. Throws GeometryError if the polygon is
/// not convex and counterclockwise.
mechanics::Frame ring_tile(const RingParts& parts, const pattern::NodeLayout& layout, const Setting& setting,
                           const geometry::Polygon& polygon);

/// A row of the catalogue: a ring with links, with these parameters to be calibrated. The parameters have to
/// outlive the row.
TileModel ring_tile_model(base::Borrowed<RingParameters> parameters, std::string summary);

}  // namespace fretwork::reduction
