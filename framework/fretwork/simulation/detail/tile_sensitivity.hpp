// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/derivatives/sensitivity.hpp>

namespace fretwork::simulation::detail {

/// Throw InputError unless a gradient has a row for each node of a surface's results.
void require_gradient(const mechanics::NodeValues& gradient, Eigen::Index nodes);

/// The adjoint motions of a tile, a row for each of its interface nodes.
struct TileAdjoint {
    mechanics::NodeValues motions;
    Eigen::VectorXd strains;  ///< adjoint strains B l; empty if TileLinearization::strains is empty
};

/// The derivatives of J for one tile.
TileSensitivity tile_sensitivity(const TileLinearization& tile, TileAdjoint adjoint,
                                 const Eigen::Vector3d& gravity);

}  // namespace fretwork::simulation::detail
