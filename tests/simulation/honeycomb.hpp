// SPDX-License-Identifier: GPL-3.0-or-later
// Projects of regular hexagons.
#pragma once

#include "hexagons.hpp"

#include <fretwork/simulation/surface.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace fretwork::test {

/// `columns` x `rows` regular hexagons of the paper's size, painted with the patterns one after the other.
/// `first_vertex` turns every tile's pattern by this number of sectors.
inline simulation::Project honeycomb(int columns, int rows, const std::vector<std::string>& patterns,
                                     int first_vertex = 0) {
    const double side = 0.015 * std::sqrt(3.0);
    simulation::Project project;
    project.tessellation = hexagons(side, columns, rows, patterns, first_vertex);
    const double w = 1.5 * side * (columns + 1);
    const double h = std::sqrt(3.0) * side * (rows + 1);
    project.outline = outlines::make_outline({{-w, -h}, {w, -h}, {w, h}, {-w, h}}, {});
    return project;
}

/// Held at the left, pulled at the right.
inline simulation::LoadCase cantilever(const Eigen::Vector3d& total_force) {
    simulation::LoadCase load_case;
    load_case.name = "cantilever";
    load_case.supports.push_back({simulation::NodesAtSide{simulation::Side::Left}, mechanics::DofSet::all()});
    load_case.loads.push_back({simulation::NodesAtSide{simulation::Side::Right}, total_force,
                               Eigen::Vector3d::Zero(), simulation::LoadCase::Amount::Total});
    return load_case;
}

}  // namespace fretwork::test
