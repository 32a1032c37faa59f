// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>

namespace fretwork::reduction::detail {

/// Check that the elements of a tile, except its beams, resist no rigid motion and have a finite stiffness.
/// Throws InputError that names the model and the motion.
void require_free_motion(const TileStructure& tile, const TileModel& model, const TileInput& input);

/// Check that the condensed stiffness of a tile's bars resists no rigid motion. The stiffness of very thin
/// bars does, by rounding. Throws NumericalError that names the motion and the thinnest bar.
void require_small_rounding(const Eigen::MatrixXd& stiffness, const mechanics::Frame& tile,
                            int interface_nodes);

}  // namespace fretwork::reduction::detail
