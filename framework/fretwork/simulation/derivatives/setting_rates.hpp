// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/surface.hpp>

#include <Eigen/Core>

#include <functional>
#include <memory>

namespace fretwork::simulation {

/// The derivatives of a tile's condensed stiffness and mass along a curve of settings.
struct TileRate {
    Eigen::MatrixXd stiffness;  ///< dK, 6n x 6n, in the axes in which the tile is built; the lower triangle
    double mass = 0.0;          ///< kg by a unit of the parameter
};

/// The derivatives of every painted tile, at 0 of the curve's parameter: central differences of fourth order.
/// Congruent tiles of one pattern share theirs.
/// @param setting  the curve of sections, joints, material or density; it is evaluated from -2 `step` to
/// 2 `step`
/// @param step  of the curve's parameter
base::IndexVector<tiling::TileIndex, std::shared_ptr<const TileRate>> rates_along(
    const Surface& surface, const std::function<reduction::Setting(double)>& setting, double step);

}  // namespace fretwork::simulation
