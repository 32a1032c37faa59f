// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/goals/case_goals.hpp>
#include <fretwork/design/search/tile_strains.hpp>
#include <fretwork/simulation/session.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace fretwork::design::detail {

/// The goals of one load case, linearized at an equilibrium. Swaps of patterns move the observations nearly
/// in a subspace. The responses to random swaps, loads and prescribed values, and the residual itself, give
/// an orthonormal basis of this subspace; a vector in it has k coefficients.
struct CaseModel {
    Eigen::VectorXd residual;  ///< k coefficients of the residual, dimensionless; the sum of their squares,
                               ///< plus `unreached`, is this case's part of the objective
    double unreached = 0.0;    ///< squared norm of the residual outside the subspace
    /// The model of one tile, in the strains of TileStrains.
    struct Tile {
        Eigen::VectorXd strains;
        Eigen::MatrixXd flexibility;
        Eigen::MatrixXd reach;      ///< map from stresses on the tile to residuals, k rows
        Eigen::VectorXd of_weight;  ///< derivative of the residuals with respect to the tile's mass, 1/kg
    };
    base::IndexVector<tiling::TileIndex, Tile> tiles;
    Eigen::MatrixXd by_loads;  ///< derivative of the residuals with respect to the factor on the loads,
                               ///< k x 1
    /// Derivative of the residuals with respect to the value of each prescribed entry, k rows.
    Eigen::MatrixXd by_prescribed;
    double energy = 0.0;  ///< elastic energy, J
    /// Flexibility of all tiles together: the symmetric part of B T^-1 B^T, with the tangent T and the slopes
    /// B of the strains. The rows and columns of a tile begin at `first`. Only with
    /// SwapSample::between_tiles.
    Eigen::MatrixXd flexibility;
    base::IndexVector<tiling::TileIndex, Eigen::Index> first;
};

/// The effect of a swap in one tile: the stress f = -(1 + dk G)^-1 dk e on the tile, and the energy f . G f.
/// dk is the change of the tile's stiffness, e are its strains, and G is its flexibility. The effect is exact
/// for a swap in one tile of the linearized surface.
struct SwapAnswer {
    Eigen::VectorXd stress;
    double energy = 0.0;
};
SwapAnswer swap_answer(const CaseModel::Tile& tile, const TileStrains::Blocks& from,
                       const TileStrains::Blocks& to);

/// The input of linearize_case().
struct CaseState {
    simulation::Session& session;
    const CaseGoals& goals;
    const mechanics::NodeValues& displacements;
    const mechanics::NodeValues& aim;  ///< argument of CaseGoals::observe()
    double scale = 1.0;                ///< factor from distances to shares, 1/m
    /// Loads at the factor 1 (N, N m), without the surface's weight, one row for each interface node.
    mechanics::NodeValues unit_loads;
};
/// The random swaps with which linearize_case() spans the subspace of a CaseModel.
struct SwapSample {
    const simulation::CandidateTiles& candidates;
    const TileStrains& strains;
    std::span<const std::size_t> painting;  ///< pattern of each tile
    std::span<const std::size_t> patterns;  ///< patterns that are swapped in
    Eigen::Index directions = 96;           ///< largest k, without the prescribed entries
    std::uint64_t seed = 1;
    int threads = 0;
    bool between_tiles = false;  ///< true: CaseModel::flexibility is computed
};
/// Linearize the goals of a load case. Pre: the session is at an equilibrium. Throws Stopped.
CaseModel linearize_case(const CaseState& state, const SwapSample& sample, const base::Control& control);

}  // namespace fretwork::design::detail
