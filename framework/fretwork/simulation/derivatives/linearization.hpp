// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/paths/equilibrium_tangent.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::simulation {

/// A tile at an equilibrium: its strains, and their derivatives with respect to motions of its nodes. A tile
/// with n interface nodes has 6n strains e, in axes that turn with it; its energy is e . K e / 2, where K is
/// its condensed stiffness.
struct TileLinearization {
    std::vector<tiling::InterfaceIndex> nodes;  ///< its interface nodes
    Eigen::VectorXd strains;                    ///< e (m, rad); empty for tile models that have none
    Eigen::MatrixXd slopes;                     ///< B = de/dx along motions of its nodes, 6n x 6n
    Eigen::MatrixXd flexibility;                ///< G = B T^-1 B^T, symmetric part; only if asked for
    double mass = 0.0;                          ///< kg; zero if gravity does not act
    Eigen::VectorXd forces;                     ///< B^T K e, on its nodes in the surface's axes (N, N m)
    double energy = 0.0;                        ///< J; zero where there are no strains
};

/// The quantities of tiles in a linearization. Flexibilities take the time of about three factorizations.
enum class TileQuantities { Strains, StrainsAndFlexibilities };

/// A surface, linearized at a nonlinear equilibrium. Valid until the next solution or edit of its session.
struct Linearization {
    mechanics::EquilibriumTangent tangent;  ///< its rows are those of the session's structure
    Eigen::Index reported_nodes = 0;        ///< number of nodes in results; they come first
    base::IndexVector<tiling::TileIndex, TileLinearization> tiles;  ///< of each tile
    mechanics::NodeValues loads;                        ///< the applied loads, one row for each node
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< m/s^2
};

}  // namespace fretwork::simulation
