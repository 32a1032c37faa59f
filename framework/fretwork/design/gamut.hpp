// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellation.hpp>

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace fretwork::design {

/// The principal curvatures of a bent surface, 1/m. The first is the larger one.
struct Curvatures {
    double largest = 0.0;
    double smallest = 0.0;
};

/// The curvatures of a surface around each tile: those of the quadric through the places of the interface
/// nodes of the tile and its neighbours, by least squares. The sides are told apart as the surface at rest
/// is: a surface that bends up (towards z) has positive curvatures. None where nodes are too few, or one has
/// no place (NaN).
/// @param places  in space, m, a row for each interface node
base::IndexVector<tiling::TileIndex, std::optional<Curvatures>> tile_curvatures(
    const tiling::Tessellation& tessellation, const Eigen::Matrix<double, Eigen::Dynamic, 3>& places);

/// The curvatures that the load gives the tiles, with single patterns; and those that the target asks for.
struct Gamut {
    /// Of every tile in every uniform painting that was tried, as the load case is, and with the best
    /// unknowns of those that got their own.
    std::vector<Curvatures> reached;
    std::vector<Curvatures> wanted;    ///< of the tiles around which every node has a goal for its place
    std::vector<Curvatures> designed;  ///< of the same tiles as `wanted`, in the painting; with all beams
    /// The share of the wanted ones that lie outside of the reached ones: farther from all of them than a
    /// tenth of the largest reached curvature. None where nothing is wanted of whole tiles.
    [[nodiscard]] std::optional<double> share_outside() const;
};

}  // namespace fretwork::design
