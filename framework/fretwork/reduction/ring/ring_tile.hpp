// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/reduction/ring/ring_parameters.hpp>

namespace fretwork::reduction {

/// A ring with links in a polygon (Section 5.1) as a frame without supports and loads.
///
/// With n interface nodes in all: nodes 0 .. n-1 are these, nodes n .. 2n-1 the ring; then n links (interface
/// node i to ring node i) and n ring beams. In the setting's regular polygon the ring is the polygon of the
/// interface nodes, turned by theta and scaled about the center so that R takes the apothem's place; in
/// another polygon each ring node keeps the barycentric place that it has there in its sector. The paper has
/// one interface node a side, and so a ring of as many nodes as sides. The material is the setting's. Throws
/// GeometryError if the polygon is not convex.
mechanics::Frame ring_tile(const RingParts& parts, const pattern::NodeLayout& layout, const Setting& setting,
                           const geometry::Polygon& polygon);

/// A row of the catalogue: a ring with links, of which a calibration fits these parameters.
TileModel ring_tile_model(const RingParameters& parameters, std::string summary);

}  // namespace fretwork::reduction
