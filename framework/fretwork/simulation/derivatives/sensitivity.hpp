// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/derivatives/candidate_tiles.hpp>
#include <fretwork/simulation/derivatives/linearization.hpp>

#include <functional>

namespace fretwork::simulation {

/// How a function J of a surface's displacements depends on one tile.
struct TileSensitivity {
    Eigen::VectorXd strains;          ///< e
    Eigen::VectorXd adjoint_strains;  ///< a = B l:  dJ = -a . dK e. Both are empty for other tile models
    double stiffness = 0.0;  ///< by a factor on the tile's stiffness, at 1; NaN for tiles made of beams
    double mass = 0.0;       ///< by the tile's mass, 1/kg: its weight is a load
    double own_mass = 0.0;   ///< kg, where gravity acts
};

/// The derivatives of a function J of a surface's displacements at a nonlinear equilibrium, by what the
/// equilibrium depends on: the adjoint method, one back-substitution for all of them.
struct Sensitivity {
    mechanics::NodeValues loads;  ///< by forces and true moments on each node: the adjoint motions l
    /// By the values of held components (prescribed or zero), one row for each node; zero for free ones.
    mechanics::NodeValues held_values;
    double stiffness = 0.0;  ///< by a factor on the stiffness of all tiles (Young's modulus, say), at 1
    base::IndexVector<tiling::TileIndex, TileSensitivity> tiles;
};

/// @param gradient  dJ by displacements and rotation vectors, a row for each node of the surface's results
/// Throws InputError if it has another number of rows; Stopped.
Sensitivity sensitivity(const Linearization& linearization, const mechanics::NodeValues& gradient,
                        const base::Control& control = {});

/// To first order, how J would change if one tile had another pattern: tiles by patterns, weight included.
/// Tiles are those of a surface whose models are all corotational; NaN for others.
Eigen::MatrixXd pattern_derivatives(const Sensitivity& sensitivity, const CandidateTiles& candidates);

/// The derivative of J along a curve of settings at 0, whose values at -2h .. 2h are asked for: sections,
/// joints, material and density act on the stiffness and the weight of the tiles. Differences of fourth order
/// of the condensed stiffness, which is smooth; J itself is not differenced.
/// @param step  h, of the curve's parameter
double derivative_along(const Sensitivity& sensitivity, const Surface& surface,
                        const std::function<reduction::Setting(double)>& setting, double step);

}  // namespace fretwork::simulation
