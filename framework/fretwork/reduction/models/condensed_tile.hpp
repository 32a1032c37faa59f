// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/reduction/response.hpp>

#include <Eigen/Core>

namespace fretwork::reduction {

/// The linear stiffness of a tile's frame, condensed onto its first `interface_nodes` nodes, the interface
/// nodes. This reduced model is exact for small displacements and needs no calibration.
///
/// Returns the 6n x 6n stiffness of the n interface nodes in their order (each with ux uy uz rx ry rz; SI,
/// global axes): symmetric, positive semidefinite, rank 6n - 6 if the frame is connected. Throws InputError
/// if an interface node has no beam, and as mechanics::assemble() and mechanics::condense().
Eigen::MatrixXd condensed_frame(const mechanics::Frame& tile, int interface_nodes);

/// The row `condensed` of the catalogue. The model has no parameters, and congruent tiles are condensed once.
TileModel condensed_tile_model();

}  // namespace fretwork::reduction
