// SPDX-License-Identifier: GPL-3.0-or-later
// A honeycomb with made-up displacements to draw and to write.
#pragma once

#include "hexagons.hpp"
#include "support.hpp"

#include <fretwork/exports/writer_catalogue.hpp>

#include <cmath>

namespace fretwork::exports::test {

using fretwork::test::complaint_of;
using fretwork::test::TemporaryFolder;

inline constexpr double kSide = 0.026;

/// A honeycomb of the paper's layout, tile t painted with pattern t modulo their number.
inline tiling::Tessellation honeycomb(int columns, int rows, const std::vector<std::string>& patterns) {
    return fretwork::test::hexagons(kSide, columns, rows, patterns);
}

inline simulation::Surface sample_surface(int columns = 3, int rows = 2) {
    simulation::Project project;
    project.tessellation = honeycomb(columns, rows, {"0-1+1-6", "1-6+3-6", "0-1+0-6+1-6"});
    return simulation::make_surface(project, nullptr);
}

/// The surface bent upwards from x = 0 on, `share` of the way: of every node (the full model), or of the
/// interface nodes only (a reduced one).
enum class Rows { EveryNode, InterfaceNodes };
inline simulation::SurfaceResult bent(const simulation::Surface& surface, Rows rows, double share = 1.0) {
    const std::size_t interfaces = surface.tessellation.interface_nodes.size();
    const tiling::TessellationFan fan = simulation::surface_fan(surface);
    const std::size_t count = rows == Rows::EveryNode ? fan.nodes.size() : interfaces;
    double xmax = 0.0;
    for (const auto& node : fan.nodes) xmax = std::max(xmax, node.x);
    simulation::SurfaceResult result;
    result.solver = "made up";
    result.solution.displacements = mechanics::NodeValues::Zero(static_cast<Eigen::Index>(count), 6);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& node = fan.nodes[i];
        result.nodes.push_back({static_cast<int>(i), {node.x, node.y, 0.0}, i < interfaces});
        const double angle = 0.9 * share * node.x / xmax;
        const double radius = xmax / (0.9 * share);
        result.solution.displacements.row(static_cast<Eigen::Index>(i)) << radius * std::sin(angle) - node.x,
            0.0, radius * (1.0 - std::cos(angle)), 0.0, -angle, 0.0;
    }
    return result;
}

inline simulation::Conditions sample_conditions(const simulation::Surface& surface) {
    simulation::Conditions conditions;
    const auto& nodes = surface.tessellation.interface_nodes;
    double xmax = 0.0;
    for (const auto& node : nodes) xmax = std::max(xmax, node.x);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const mechanics::NodeIndex index(i);
        if (nodes[i].x < 0.0) {
            conditions.supports.push_back({index, nodes[i].y < 2 * kSide
                                                      ? mechanics::DofSet::all()
                                                      : mechanics::DofSet::translations()});
        }
        if (nodes[i].x > xmax - 0.6 * kSide) {
            mechanics::NodalLoad load{index};
            load.force = {0.0, 0.4, 1.0};
            conditions.loads.push_back(load);
        }
    }
    return conditions;
}

}  // namespace fretwork::exports::test
