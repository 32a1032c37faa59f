// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction {

/// The paper's ring with links, but with a section for the ring and another one for the links, a row of the
/// catalogue. Ten calibrated parameters: area (stretching), I2 and I3 (bending out of the plane and in it)
/// and J (torsion) of each, theta and R as in the paper's model, which is the case of equal sections.
TileModel ring10_tile_model();

}  // namespace fretwork::reduction
