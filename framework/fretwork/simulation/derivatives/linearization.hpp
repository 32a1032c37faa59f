// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium_tangent.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::simulation {

/// A tile at an equilibrium: its strains, and their derivatives with respect to motions of its nodes. A tile
/// with n interface nodes has 6n strains e, in axes that turn with the tile. The energy of the tile is e . K
/// e / 2, where K is its condensed stiffness.
struct TileLinearization {
    std::vector<tiling::InterfaceIndex> nodes;  ///< interface nodes of the tile
    Eigen::VectorXd strains;                    ///< strains e (m, rad); empty for tile models without strains
    Eigen::MatrixXd slopes;                     ///< slopes B = de/dx along motions of the nodes, 6n x 6n
    /// Flexibility G, the symmetric part of B T^-1 B^T, with the tangent T (Linearization::tangent); only
    /// with TileQuantities::StrainsAndFlexibilities.
    Eigen::MatrixXd flexibility;
    double mass = 0.0;  ///< mass, kg; zero if gravity does not act
    /// Forces B^T K e on the nodes, in the surface's axes (N, N m).
    Eigen::VectorXd forces;
    double energy = 0.0;  ///< energy, J; zero for tile models without strains
};

/// The quantities of tiles in a linearization. Flexibilities take about as long as three factorizations.
enum class TileQuantities {
    Strains,                 ///< strains of each tile
    StrainsAndFlexibilities  ///< strains and flexibilities of each tile
};

/// A surface, linearized at a nonlinear equilibrium. The linearization is valid until the next solution or
/// edit of its session.
struct Linearization {
    mechanics::EquilibriumTangent tangent;  ///< response of the session's structure to small changes
    Eigen::Index reported_nodes = 0;        ///< number of nodes in results, which come first
    base::IndexVector<tiling::TileIndex, TileLinearization> tiles;  ///< linearization of each tile
    /// Applied loads (N, N m), one row for each node of the structure, also of those that results leave out.
    mechanics::NodeValues loads;
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< m/s^2
};

}  // namespace fretwork::simulation
