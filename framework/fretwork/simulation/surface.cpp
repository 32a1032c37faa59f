// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/surface.hpp>

#include <algorithm>

namespace fretwork::simulation {

Surface make_surface(const Project& project, const library::Library* library) {
    if (library != nullptr) library->check_layout(project.layout);
    Surface surface{
        project.layout, project.tessellation, setting_of(project, library), {}, models_by_tile(project)};
    for (const pattern::NamedPattern& pattern : project.tessellation.patterns) {
        surface.calibrations.push_back(library != nullptr ? library->best_calibrations(pattern.id)
                                                          : std::vector<reduction::Calibration>{});
    }
    return surface;
}

tiling::TessellationFan surface_fan(const Surface& surface) {
    return tiling::assemble_fans(surface.layout, surface.tessellation);
}

base::IndexVector<tiling::TileIndex, double> tile_masses(const Surface& surface) {
    base::IndexVector<tiling::TileIndex, double> masses(surface.tessellation.tiles.size(), 0.0);
    const double mass_per_length = surface.setting.material.density * surface.setting.section.area;
    const tiling::TessellationFan fan = surface_fan(surface);
    for (const tiling::TessellationFan::Edge& edge : fan.edges) {
        masses[edge.tile] +=
            mass_per_length * geometry::distance(fan.nodes[edge.nodes[0]], fan.nodes[edge.nodes[1]]);
    }
    return masses;
}

}  // namespace fretwork::simulation
