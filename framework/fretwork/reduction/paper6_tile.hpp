// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/polygon.hpp>
#include <fretwork/reduction/paper6_parameters.hpp>
#include <fretwork/reduction/tile_model.hpp>

namespace fretwork::reduction {

/// The paper's six-parameter reduced model of a tile (Section 5.1) as a frame without supports and loads.
///
/// Of n sides: nodes 0 .. n-1 are the interface nodes in the middle of the sides, nodes n .. 2n-1 the ring;
/// then n links (interface node i to ring node i) and n ring beams. Ring node i keeps, in sector i of the
/// polygon, the barycentric place that (theta, R) give it in the setting's regular polygon. The section is
/// that of the parameters, the material the setting's. Throws GeometryError if the polygon is not convex.
mechanics::Frame paper6_tile(const Paper6Parameters& parameters, const Setting& setting,
                             const pattern::Polygon& polygon);

/// The row of the catalogue: links and ring of one section, calibrated.
TileModel paper6_tile_model();

}  // namespace fretwork::reduction
