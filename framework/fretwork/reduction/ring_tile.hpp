// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/polygon.hpp>
#include <fretwork/reduction/ring_parameters.hpp>
#include <fretwork/reduction/tile_model.hpp>

namespace fretwork::reduction {

/// A ring with links in a polygon (Section 5.1) as a frame without supports and loads.
///
/// Of n sides: nodes 0 .. n-1 are the interface nodes in the middle of the sides, nodes n .. 2n-1 the ring;
/// then n links (interface node i to ring node i) and n ring beams. Ring node i keeps, in sector i of the
/// polygon, the barycentric place that (theta, R) give it in the setting's regular polygon. The material is
/// the setting's. Throws GeometryError if the polygon is not convex.
mechanics::Frame ring_tile(const RingParts& parts, const Setting& setting, const pattern::Polygon& polygon);

/// A row of the catalogue: a ring with links, of which a calibration fits these parameters.
TileModel ring_tile_model(const RingParameters& parameters, std::string summary);

}  // namespace fretwork::reduction
