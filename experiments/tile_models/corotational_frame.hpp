// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::tile_models {

/// A row for large displacements from one for small ones, of the name `corotational_NAME`: each tile turns
/// with a frame of its own and answers with the other's stiffness, condensed onto the interface nodes.
/// Parameters and calibration are those of the other row, so they are fitted by linear displacements.
reduction::TileModel corotational(reduction::TileModel linear);

}  // namespace fretwork::tile_models
