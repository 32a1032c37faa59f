// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/surface.hpp>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace fretwork::simulation::detail {

/// The polygon from which a session builds a tile.
struct TilePolygon {
    geometry::Polygon polygon;  ///< in the tile's own axes if the tile can be shared, otherwise the surface's
    std::string key;            ///< equal for congruent tiles; the tile's number if it is not shared
};
TilePolygon tile_polygon_of(const Surface& surface, tiling::TileIndex tile, double grid);

/// A pattern in a polygon, condensed onto its interface nodes; and the mass of its beams, kg.
struct CondensedPattern {
    Eigen::MatrixXd stiffness;
    double mass = 0.0;
    std::vector<Eigen::Vector3d> interface_nodes{};  ///< in the axes of the polygon, m
};
/// Throws InputError if an interface node has no beam.
CondensedPattern condensed_pattern(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                   const geometry::Polygon& polygon, const reduction::Setting& setting);

}  // namespace fretwork::simulation::detail
