// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/surface.hpp>

#include <Eigen/Core>

#include <functional>
#include <memory>

namespace fretwork::simulation {

/// The derivatives of a tile's condensed stiffness and mass along a curve of settings.
struct TileRate {
    /// Derivative of K, 6n x 6n, in the axes in which the tile is built; only the lower triangle.
    Eigen::MatrixXd stiffness;
    double mass = 0.0;  ///< derivative of the mass, kg per unit of the curve's parameter
};

/// The derivatives of every tile, at 0 of the curve's parameter, by central differences of fourth order.
/// Congruent tiles with the same pattern share a TileRate. Throws InputError if a tile is not painted, or if
/// an interface node has no beam.
/// @param setting  the curve of sections, joints, material or density, evaluated from -2 `step` to 2 `step`
/// @param step  the step of the curve's parameter for the differences
base::IndexVector<tiling::TileIndex, std::shared_ptr<const TileRate>> rates_along(
    const Surface& surface, const std::function<reduction::Setting(double)>& setting, double step);

}  // namespace fretwork::simulation
