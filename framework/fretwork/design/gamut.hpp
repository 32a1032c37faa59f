// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellation.hpp>

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace fretwork::design {

/// The principal curvatures of a bent surface at a point, 1/m.
struct Curvatures {
    double largest = 0.0;   ///< larger principal curvature
    double smallest = 0.0;  ///< smaller principal curvature
};

/// Compute the principal curvatures of a surface at each tile. A quadric is fitted by least squares to the
/// interface nodes of the tile and its neighbours. Curvatures are positive where the surface bends towards
/// the side that faces z at rest. A tile has none if there are fewer than six nodes, if they do not determine
/// a quadric, or if the position of a node is unknown (NaN).
/// @param places  positions of the interface nodes in space, m, one row for each node
base::IndexVector<tiling::TileIndex, std::optional<Curvatures>> tile_curvatures(
    const tiling::Tessellation& tessellation, const Eigen::Matrix<double, Eigen::Dynamic, 3>& places);

/// The curvatures that single patterns reach under the load, and the curvatures that the target needs.
struct Gamut {
    /// Curvatures of every tile in every uniform painting with a stable equilibrium, under each load case. If
    /// there are free unknowns, the curvatures after their fit are added.
    std::vector<Curvatures> reached;
    /// Curvatures of the target under each load case, at the tiles with goals for all nodes of the tile and
    /// its neighbours. Free components of a goal are those of the painting.
    std::vector<Curvatures> wanted;
    /// Curvatures of the painting at the tiles of `wanted`, computed by the full model.
    std::vector<Curvatures> designed;
    /// The share of the wanted curvatures that no single pattern reaches: their distance from every reached
    /// curvature exceeds a tenth of the largest reached curvature. None if `wanted` or `reached` is empty.
    [[nodiscard]] std::optional<double> share_outside() const;
};

}  // namespace fretwork::design
