// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction::detail {

/// Check that the elements of a tile, except its beams, resist no rigid motion and have a finite stiffness.
/// Throws InputError that names the model and the motion.
void require_free_motion(const TileStructure& tile, const TileModel& model, const TileInput& input);

}  // namespace fretwork::reduction::detail
