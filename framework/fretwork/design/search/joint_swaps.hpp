// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/case_model.hpp>

#include <Eigen/Core>

#include <span>

namespace fretwork::design::detail {

/// A change of one tile's stiffness and mass.
struct TileSwap {
    tiling::TileIndex tile;
    const TileStrains::Blocks& from;
    const TileStrains::Blocks& to;
    double mass = 0.0;  ///< change of the tile's mass, kg
};

/// The effect of swaps in several tiles at once.
struct JointAnswer {
    Eigen::VectorXd residuals;  ///< change of the residuals, k coefficients
    double energy = 0.0;        ///< energy f . G f of the change, J
};

/// Compute the effect of swaps. The stresses f of all these tiles solve f = -dk (e + G f), with the changes
/// dk of the tiles' stiffness and their strains e, where the flexibility G includes the coupling of tiles.
/// The effect is exact on the linearized surface.
/// Pre: the model has CaseModel::flexibility.
JointAnswer joint_answer(const CaseModel& model, std::span<const TileSwap> swaps);

}  // namespace fretwork::design::detail
