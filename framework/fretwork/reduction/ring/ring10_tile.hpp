// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction {

/// The row `ring10` of the catalogue: the paper's ring with links, with one section for the ring and another
/// for the links. Its ten parameters are calibrated: for each section the area (stretching), I2 (bending out
/// of the plane), I3 (bending in the plane) and J (torsion); theta and R as in the paper's model. The paper's
/// model is the case of equal sections.
TileModel ring10_tile_model();

}  // namespace fretwork::reduction
