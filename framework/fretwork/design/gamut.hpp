// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellation.hpp>

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace fretwork::design {

/// The principal curvatures of a bent surface at a place, 1/m.
struct Curvatures {
    double largest = 0.0;   ///< larger principal curvature
    double smallest = 0.0;  ///< smaller principal curvature
};

/// The principal curvatures of a surface at each tile: the curvatures of the quadric that fits, by least
/// squares, the places of the interface nodes of the tile and its neighbours. A surface that bends towards z
/// has positive curvatures. None for a tile with too few nodes, or with a node without a place (NaN).
/// @param places  places of the interface nodes in space, m, one row for each
base::IndexVector<tiling::TileIndex, std::optional<Curvatures>> tile_curvatures(
    const tiling::Tessellation& tessellation, const Eigen::Matrix<double, Eigen::Dynamic, 3>& places);

/// The curvatures that tiles with single patterns reach under the load, and the curvatures that the target
/// wants.
struct Gamut {
    /// The curvatures of every tile in every uniform painting that was tried, under the load case as it is;
    /// for uniform paintings that were fitted, also with their own best unknowns.
    std::vector<Curvatures> reached;
    /// Wanted curvatures, for the tiles around which every node has a goal for its place.
    std::vector<Curvatures> wanted;
    /// Curvatures in the painting, with all beams, for the tiles of `wanted`.
    std::vector<Curvatures> designed;
    /// The share of the wanted curvatures that lie outside the reached curvatures: their distance from each
    /// reached curvature is above a tenth of the largest reached curvature. None if `wanted` is empty.
    [[nodiscard]] std::optional<double> share_outside() const;
};

}  // namespace fretwork::design
