// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/exports/line_set.hpp>

#include <cstdio>

namespace fretwork::exports {
namespace {

using simulation::Surface;

void require_same_surface(const Surface& surface, const mechanics::Result& result) {
    constexpr double kTolerance = 1e-9;  // metres
    const auto& places = surface.tessellation.interface_nodes;
    const auto fail = [](const std::string& what) {
        throw base::InputError("the result is not one of this project: " + what);
    };
    if (result.nodes.size() < places.size()) fail("it has too few nodes");
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Eigen::Vector3d place(places[i].x, places[i].y, 0.0);
        if (!result.nodes[i].is_interface || (result.nodes[i].rest_position - place).norm() > kTolerance) {
            fail("its node " + std::to_string(i) + " is not the interface node of that number");
        }
    }
}

/// Each tile as the closed line through its interface nodes.
LineSet tile_loops(const Surface& surface) {
    LineSet set;
    for (const pattern::Point2& node : surface.tessellation.interface_nodes)
        set.nodes.emplace_back(node.x, node.y, 0.0);
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        const tiling::Tile& tile = surface.tessellation.tiles[t];
        for (std::size_t k = 0; k < tile.interface_nodes.size(); ++k) {
            const auto next = tile.interface_nodes[(k + 1) % tile.interface_nodes.size()];
            set.lines.push_back({tile.interface_nodes[k].value, next.value});
            set.tiles.push_back(static_cast<int>(t));
            set.patterns.push_back(tile.pattern);
        }
    }
    return set;
}

}  // namespace

LineSet surface_lines(const Surface& surface) {
    LineSet set;
    for (const pattern::Point2& node : surface.fan.nodes) set.nodes.emplace_back(node.x, node.y, 0.0);
    for (const tiling::TessellationFan::Edge& edge : surface.fan.edges) {
        set.lines.push_back({edge.nodes[0].value, edge.nodes[1].value});
        set.tiles.push_back(edge.tile.value);
        set.patterns.push_back(surface.tessellation.tiles[static_cast<std::size_t>(edge.tile)].pattern);
    }
    return set;
}

LineSet result_lines(const Surface& surface, const mechanics::Result& result) {
    require_same_surface(surface, result);
    const bool has_every_beam = result.nodes.size() == surface.fan.nodes.size();
    LineSet set = has_every_beam ? surface_lines(surface) : tile_loops(surface);
    set.displacements = result.solution.displacements.topRows(static_cast<Eigen::Index>(set.nodes.size()));
    return set;
}

LineSet frame_lines(const mechanics::Frame& frame) {
    LineSet set;
    set.nodes = frame.nodes;
    for (const mechanics::Beam& beam : frame.beams)
        set.lines.push_back({beam.nodes[0].value, beam.nodes[1].value});
    return set;
}

std::vector<NodeField> mode_fields(const mechanics::Result& result) {
    std::vector<NodeField> fields;
    const auto add = [&](const char* kind, const std::vector<mechanics::Mode>& modes, const char* unit) {
        for (std::size_t i = 0; i < modes.size(); ++i) {
            char name[64];
            std::snprintf(name, sizeof name, "%s %zu, %.6g %s", kind, i + 1, modes[i].value, unit);
            fields.push_back({name, modes[i].shape.leftCols<3>()});
        }
    };
    add("vibration", result.vibration_modes, "Hz");
    add("buckling", result.buckling_modes, "times the load");
    return fields;
}

std::vector<Eigen::Vector3d> displaced_nodes(const LineSet& lines, double scale) {
    std::vector<Eigen::Vector3d> places = lines.nodes;
    if (!lines.displacements) return places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] += scale * lines.displacements->row(static_cast<Eigen::Index>(i)).head<3>().transpose();
    }
    return places;
}

}  // namespace fretwork::exports
