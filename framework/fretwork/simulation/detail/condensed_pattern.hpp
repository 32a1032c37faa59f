// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/surface.hpp>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace fretwork::simulation::detail {

/// The polygon from which a tile is built, as the sessions' tiles are.
struct TilePolygon {
    geometry::Polygon polygon;  ///< in the tile's own axes if it can be shared
    std::string key;            ///< equal for congruent tiles; of one that is not shared its number
};
TilePolygon tile_polygon_of(const Surface& surface, tiling::TileIndex tile, double grid);

/// A pattern in a polygon, condensed onto its interface nodes; and the mass of its beams, kg.
struct CondensedPattern {
    Eigen::MatrixXd stiffness;
    double mass = 0.0;
    std::vector<Eigen::Vector3d> interface_nodes{};  ///< in the axes of the polygon, m
};
/// Throws InputError if the pattern does not connect the tile.
CondensedPattern condensed_pattern(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                   const geometry::Polygon& polygon, const reduction::Setting& setting);

}  // namespace fretwork::simulation::detail
