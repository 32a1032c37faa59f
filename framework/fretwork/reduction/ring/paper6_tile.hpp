// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction {

/// The row `paper6` of the catalogue, the paper's reduced model (Section 5.1): a ring with links, where ring
/// and links have the same section. Its six parameters are calibrated.
TileModel paper6_tile_model();

}  // namespace fretwork::reduction
