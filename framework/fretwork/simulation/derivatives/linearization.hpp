// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium_tangent.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::simulation {

/// A tile at an equilibrium: its strains, and how they follow its nodes. A tile of n interface nodes has 6n
/// strains e, in its own axes as they turn with it, and the energy e . K e / 2 with its condensed stiffness
/// K.
struct TileLinearization {
    std::vector<tiling::InterfaceIndex> nodes;
    Eigen::VectorXd strains;      ///< e (m, rad); empty: the tile's model is made otherwise
    Eigen::MatrixXd slopes;       ///< B = de/dx along motions of its nodes, 6n x 6n
    Eigen::MatrixXd flexibility;  ///< G = B T^-1 B^T, symmetric part; only where it was asked for
    double mass = 0.0;            ///< kg; zero where gravity does not act
    Eigen::VectorXd forces;       ///< B^T K e, on its nodes in the surface's axes (N, N m)
};

/// Which quantities of the tiles a linearization has: their flexibilities take about three factorizations.
enum class TileQuantities { Strains, StrainsAndFlexibilities };

/// A surface at a nonlinear equilibrium, to first order. Valid until the next solution or edit of its
/// session.
struct Linearization {
    mechanics::EquilibriumTangent tangent;  ///< its rows are those of the session's structure
    Eigen::Index reported_nodes = 0;        ///< the nodes of results are the first ones
    base::IndexVector<tiling::TileIndex, TileLinearization> tiles;
    mechanics::NodeValues loads;                        ///< that act, one row for each node
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< m/s^2
};

}  // namespace fretwork::simulation
