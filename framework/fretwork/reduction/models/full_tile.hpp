// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction {

/// The full model: every beam of the pattern, one element each, at large displacements.
TileModel full_tile_model();

}  // namespace fretwork::reduction
