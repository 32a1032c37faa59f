// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/surface.hpp>

#include <algorithm>
#include <cmath>

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
        const geometry::Point2& a = fan.nodes[edge.nodes[0]];
        const geometry::Point2& b = fan.nodes[edge.nodes[1]];
        masses[edge.tile] += mass_per_length * std::hypot(b.x - a.x, b.y - a.y);
    }
    return masses;
}

}  // namespace fretwork::simulation
