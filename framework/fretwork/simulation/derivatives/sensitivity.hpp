// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/derivatives/candidate_tiles.hpp>
#include <fretwork/simulation/derivatives/linearization.hpp>

#include <functional>

namespace fretwork::simulation {

/// The derivatives of a function J of a surface's displacements with respect to properties of one tile.
struct TileSensitivity {
    Eigen::VectorXd strains;  ///< strains e
    /// Adjoint strains a = B l, with dJ = -a . dK e; empty, like `strains`, for tile models without strains.
    Eigen::VectorXd adjoint_strains;
    /// Derivative of J with respect to a factor on the tile's stiffness, at 1; NaN if `strains` is empty.
    double stiffness = 0.0;
    /// Derivative of J with respect to the tile's mass, through the load by its weight, 1/kg.
    double mass = 0.0;
    double own_mass = 0.0;  ///< mass of the tile, kg; zero if gravity does not act
    double energy = 0.0;    ///< elastic energy of the tile, J; zero for tile models without strains
};

/// The derivatives of a function J of a surface's displacements at an equilibrium, with respect to loads,
/// held values and tiles. The adjoint method gives all derivatives with one back-substitution.
struct Sensitivity {
    /// Derivatives of J with respect to forces and moments on the nodes, one row for each node: the adjoint
    /// motions l. Moments are about the surface's axes.
    mechanics::NodeValues loads;
    /// The derivatives of J with respect to the values of held components (prescribed or zero), one row for
    /// each node; zero for free components.
    mechanics::NodeValues held_values;
    /// Derivative of J with respect to a factor on the stiffness of all tiles, such as on Young's modulus, at
    /// 1.
    double stiffness = 0.0;
    /// Derivatives with respect to properties of each tile.
    base::IndexVector<tiling::TileIndex, TileSensitivity> tiles;
};

/// The sensitivity of a function J with a given gradient. Throws InputError if the number of rows of the
/// gradient is wrong; NumericalError if the tangent is nearly singular; Stopped.
/// @param gradient  the derivatives of J with respect to displacements and rotation vectors, one row for each
/// node of the surface's results
Sensitivity sensitivity(const Linearization& linearization, const mechanics::NodeValues& gradient,
                        const base::Control& control = {});

/// The sensitivity of J + weight U, where U is the elastic energy. Adds the derivatives of U with respect to
/// stiffnesses at fixed nodes.
/// @param by  the sensitivity for the gradient of J plus weight times Session::energy_gradient()
/// @param energy  the elastic energy U of the surface, J
Sensitivity with_energy(Sensitivity by, double weight, double energy);

/// The change of J, to first order, if one tile has another pattern: one row for each tile, one column for
/// each pattern. The tile's weight is included. NaN for tiles without TileSensitivity::strains: those made
/// of beams, and condensed tiles in a nonlinear solution.
Eigen::MatrixXd pattern_derivatives(const Sensitivity& sensitivity, const CandidateTiles& candidates);

/// The derivative of J along a curve of settings, at 0 of its parameter. Sections, joints, material and
/// density act on the tiles' stiffness and weight. The derivatives of these two are central differences of
/// fourth order; J itself is not differenced. NaN if a tile has no TileSensitivity::strains. Throws as
/// rates_along().
/// @param setting  the curve, evaluated from -2 `step` to 2 `step`
/// @param step  the step of the curve's parameter for the differences
double derivative_along(const Sensitivity& sensitivity, const Surface& surface,
                        const std::function<reduction::Setting(double)>& setting, double step);

}  // namespace fretwork::simulation
