// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction {

/// The paper's reduced model (Section 5.1), a row of the catalogue: a ring with links of one section, whose
/// six parameters are calibrated.
TileModel paper6_tile_model();

}  // namespace fretwork::reduction
