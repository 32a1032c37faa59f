// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellation.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace fretwork::simulation::detail {

/// A polygon in its own axes: the origin in its centroid, x along its first side.
struct OwnAxes {
    Eigen::Matrix3d turn;             ///< from these axes to the surface's, about z
    Eigen::Vector3d origin;           ///< of these axes in the surface, m
    geometry::Polygon polygon;        ///< rounded to the grid, m
    std::vector<std::int64_t> steps;  ///< its coordinates in steps of the grid: equal for congruent polygons
};

/// The grid of a tessellation, m: a power of two near a billionth of the mean tile side. Rounding to it moves
/// stiffnesses by some billionths; rounding errors of the coordinates are a million times smaller.
double congruence_grid(const tiling::Tessellation& tessellation);

OwnAxes own_axes(const geometry::Polygon& polygon, double grid);

/// The axes and the rounded polygon of a tile that can be shared. None if the rounded polygon is not convex,
/// because rounding has bent a straight corner inwards: the tile is then built in the surface's axes.
std::optional<OwnAxes> shared_axes(const geometry::Polygon& polygon, double grid);

}  // namespace fretwork::simulation::detail
