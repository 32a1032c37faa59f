// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/derivatives/candidate_tiles.hpp>
#include <fretwork/simulation/derivatives/linearization.hpp>

#include <functional>

namespace fretwork::simulation {

/// The derivatives of a function J of a surface's displacements with respect to properties of one tile.
struct TileSensitivity {
    Eigen::VectorXd strains;          ///< e
    Eigen::VectorXd adjoint_strains;  ///< a = B l:  dJ = -a . dK e. Both are empty for other tile models
    double stiffness = 0.0;  ///< dJ by a factor on the tile's stiffness, at 1; NaN for tiles made of beams
    double mass = 0.0;       ///< dJ by the tile's mass, 1/kg: its weight is a load
    double own_mass = 0.0;   ///< kg, where gravity acts
    double energy = 0.0;     ///< J, of the tile; zero for other tile models
};

/// The derivatives of a function J of a surface's displacements at an equilibrium, by loads, held values and
/// tiles. The adjoint method gives all of them with one back-substitution.
struct Sensitivity {
    mechanics::NodeValues loads;  ///< dJ by forces and true moments on each node: the adjoint motions l
    /// dJ by the values of held components (prescribed or zero), one row for each node; zero for free ones.
    mechanics::NodeValues held_values;
    double stiffness = 0.0;  ///< dJ by a factor on the stiffness of all tiles (say, Young's modulus), at 1
    base::IndexVector<tiling::TileIndex, TileSensitivity> tiles;  ///< of each tile
};

/// The sensitivity of a function J with this gradient. Throws InputError if the number of rows of the
/// gradient is wrong; Stopped.
/// @param gradient  dJ by displacements and rotation vectors, a row for each node of the surface's results
Sensitivity sensitivity(const Linearization& linearization, const mechanics::NodeValues& gradient,
                        const base::Control& control = {});

/// The sensitivity of J + weight U, where U is the elastic energy: adds how U depends on stiffnesses while
/// nothing moves. The gradient of `by` has weight times Session::energy_gradient in it already.
/// @param energy  U of the surface, J
Sensitivity with_energy(Sensitivity by, double weight, double energy);

/// The change of J, to first order, if one tile had another pattern: a row for each tile, a column for each
/// pattern; the weight of the tile is included. NaN for tiles
/// that are neither corotational nor condensed.
Eigen::MatrixXd pattern_derivatives(const Sensitivity& sensitivity, const CandidateTiles& candidates);

/// The derivative of J along a curve of settings, at 0 of its parameter. Sections, joints, material and
/// density act on the stiffness and the weight of the tiles, whose derivatives are central differences of
/// fourth order; J itself is not differenced.
/// @param setting  the curve; it is evaluated from -2 `step` to 2 `step`
/// @param step  of the curve's parameter
double derivative_along(const Sensitivity& sensitivity, const Surface& surface,
                        const std::function<reduction::Setting(double)>& setting, double step);

}  // namespace fretwork::simulation
