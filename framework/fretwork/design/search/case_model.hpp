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

/// The goals of one load case near an equilibrium. Of all that they observe, it keeps the part that swaps of
/// patterns reach: k numbers, an orthonormal basis of the observed answers to random swaps.
struct CaseModel {
    Eigen::VectorXd
        residual;  ///< k numbers; without unit, so that the square of all is a mean of squared shares
    double unreached = 0.0;  ///< square of the residual's part that is left out
    /// A tile and its answer to another stiffness, in the strains of TileStrains.
    struct Tile {
        Eigen::VectorXd strains;
        Eigen::MatrixXd flexibility;
        Eigen::MatrixXd reach;      ///< from stresses on the tile to residuals, k rows
        Eigen::VectorXd of_weight;  ///< residuals by the tile's mass, 1/kg
    };
    base::IndexVector<tiling::TileIndex, Tile> tiles;
    Eigen::MatrixXd by_loads;       ///< residuals by the factor on the loads, k x 1
    Eigen::MatrixXd by_prescribed;  ///< by the value of each prescribed entry, k rows
    double energy = 0.0;            ///< J, elastic
};

/// How the stress on a tile changes if its stiffness does: the answer f = -(1 + dk G)^-1 dk e, exact for one
/// tile in the linearized surface, with e its strains and G its flexibility; and its energy f . G f.
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
    const mechanics::NodeValues& aim;  ///< as CaseGoals::observe
    double scale = 1.0;                ///< 1/m: residuals are made shares by it
    mechanics::NodeValues unit_loads;  ///< at the factor 1, without weight; a row for each node
};
/// Which swaps the basis is made of.
struct SwapSample {
    const simulation::CandidateTiles& candidates;
    const TileStrains& strains;
    std::span<const std::size_t> painting;  ///< the pattern of each tile
    std::span<const std::size_t> patterns;  ///< those that are swapped in
    Eigen::Index directions = 96;           ///< k, at most
    std::uint64_t seed = 1;
    int threads = 0;
};
/// The session is at an equilibrium. Throws Stopped.
CaseModel linearize_case(const CaseState& state, const SwapSample& sample, const base::Control& control);

}  // namespace fretwork::design::detail
