// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction {

/// The row `full` of the catalogue: every beam of the pattern is one element, at large displacements.
TileModel full_tile_model();

}  // namespace fretwork::reduction
