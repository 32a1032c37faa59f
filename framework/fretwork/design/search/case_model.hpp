// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/case_goals.hpp>
#include <fretwork/design/search/tile_strains.hpp>
#include <fretwork/simulation/session.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace fretwork::design::detail {

/// The goals of one load case, linearized at an equilibrium. Swaps of patterns reach only a subspace of the
/// observations. Its orthonormal basis comes from the responses to random swaps, and k coefficients describe
/// a vector in it.
struct CaseModel {
    Eigen::VectorXd
        residual;  ///< k coefficients, dimensionless: the sum of their squares is a mean of squared shares
    double unreached = 0.0;  ///< squared norm of the residual outside the subspace
    /// One tile, in the strains of TileStrains.
    struct Tile {
        Eigen::VectorXd strains;
        Eigen::MatrixXd flexibility;
        Eigen::MatrixXd reach;      ///< from stresses on the tile to residuals, k rows
        Eigen::VectorXd of_weight;  ///< derivative of the residuals with respect to the tile's mass, 1/kg
    };
    base::IndexVector<tiling::TileIndex, Tile> tiles;
    Eigen::MatrixXd by_loads;       ///< derivative of the residuals with respect to the factor on the loads,
                                    ///< k x 1
    Eigen::MatrixXd by_prescribed;  ///< derivative with respect to the value of each prescribed entry, k rows
    double energy = 0.0;            ///< J, elastic
};

/// The stress on a tile after a change dk of its stiffness, f = -(1 + dk G)^-1 dk e, where e are its strains
/// and G its flexibility; and the energy f . G f. Exact for one tile of the linearized surface.
struct SwapAnswer {
    Eigen::VectorXd stress;
    double energy = 0.0;
};
SwapAnswer swap_answer(const CaseModel::Tile& tile, const TileStrains::Blocks& from,
                       const TileStrains::Blocks& to);

/// The input of a case's model.
struct CaseState {
    simulation::Session& session;
    const CaseGoals& goals;
    const mechanics::NodeValues& displacements;
    const mechanics::NodeValues& aim;  ///< the argument of CaseGoals::observe()
    double scale = 1.0;                ///< 1/m, from distances to shares
    mechanics::NodeValues unit_loads;  ///< at the factor 1, without the surface's weight; a row for each node
};
/// The swaps that span the basis.
struct SwapSample {
    const simulation::CandidateTiles& candidates;
    const TileStrains& strains;
    std::span<const std::size_t> painting;  ///< the pattern of each tile
    std::span<const std::size_t> patterns;  ///< the patterns that are swapped in
    Eigen::Index directions = 96;           ///< the largest k
    std::uint64_t seed = 1;
    int threads = 0;
};
/// Linearize the goals of a case. The session has to be at an equilibrium. Throws Stopped.
CaseModel linearize_case(const CaseState& state, const SwapSample& sample, const base::Control& control);

}  // namespace fretwork::design::detail
