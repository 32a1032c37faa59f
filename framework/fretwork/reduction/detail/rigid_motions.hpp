// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction::detail {

/// Throw InputError that names the model and the motion if an element of a tile, other than a beam, meets a
/// rigid motion with a force, or has a stiffness that is not finite.
void require_free_motion(const TileStructure& tile, const TileModel& model, const TileInput& input);

}  // namespace fretwork::reduction::detail
