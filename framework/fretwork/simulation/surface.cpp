// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/surface.hpp>

#include <cmath>

namespace fretwork::simulation {

Surface make_surface(const Project& project, const library::Library* library) {
    if (library != nullptr) library->check_layout(project.layout);
    Surface surface{project.layout,
                    project.tessellation,
                    tiling::assemble_fans(project.layout, project.tessellation),
                    {},
                    library != nullptr ? library->setting() : reduction::paper_setting(),
                    {}};
    for (const std::string& id : project.tessellation.patterns) {
        surface.patterns.push_back(pattern::parse_pattern_id(project.layout, id));
        auto record = library != nullptr ? library->best_calibration(id) : std::nullopt;
        surface.calibrations.push_back(record ? std::optional(std::move(record->calibration)) : std::nullopt);
    }
    return surface;
}

std::vector<double> tile_masses(const Surface& surface) {
    std::vector<double> masses(surface.tessellation.tiles.size(), 0.0);
    const double mass_per_length = surface.setting.material.density * surface.setting.section.area;
    for (const tiling::TessellationFan::Edge& edge : surface.fan.edges) {
        const pattern::Point2& a = surface.fan.nodes[static_cast<std::size_t>(edge.nodes[0])];
        const pattern::Point2& b = surface.fan.nodes[static_cast<std::size_t>(edge.nodes[1])];
        masses[static_cast<std::size_t>(edge.tile)] += mass_per_length * std::hypot(b.x - a.x, b.y - a.y);
    }
    return masses;
}

}  // namespace fretwork::simulation
