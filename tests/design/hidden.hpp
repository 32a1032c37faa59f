// SPDX-License-Identifier: GPL-3.0-or-later
// Small surfaces, and targets that a hidden painting of them reaches.
#pragma once

#include "simulation/honeycomb.hpp"

#include <fretwork/design/design.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace fretwork::test {

/// From soft to stiff.
inline const std::vector<std::string> kDesignPatterns = {"0-6", "0-1+1-6", "1-6+3-6", "0-1+0-6+1-6",
                                                         "0-1+1-5+1-6+5-6"};

inline simulation::Project cantilever_project(int columns, int rows, double force) {
    simulation::Project project = honeycomb(columns, rows, {kDesignPatterns[1]});
    project.setting = reduction::paper_setting();
    project.load_cases.push_back(cantilever({0.0, 0.0, force}));
    return project;
}

/// Every tile's pattern by its place: graded along x.
inline void paint_graded(simulation::Project& project, const std::vector<std::string>& patterns) {
    tiling::Tessellation& tessellation = project.tessellation;
    tessellation.patterns = pattern::parse_named_patterns(project.layout, patterns);
    const auto tiles = tessellation.tiles.size();
    for (std::size_t t = 0; t < tiles; ++t) {
        const double share = 0.5 + 0.5 * std::sin(6.0 * static_cast<double>(t) / static_cast<double>(tiles));
        const auto last = static_cast<double>(patterns.size() - 1);
        tessellation.tiles[t].pattern = static_cast<int>(std::lround(share * last));
    }
}

/// The displacements of all interface nodes with all beams.
inline design::Target target_of(const simulation::Project& hidden) {
    const simulation::Surface surface = simulation::make_surface(hidden, nullptr);
    const auto result =
        simulation::simulate(surface, hidden.load_cases.front(), {.model = "full", .threads = 1});
    design::NodesGoal goal;
    for (int node = 0; node < static_cast<int>(hidden.tessellation.interface_nodes.size()); ++node) {
        const auto row = result.solution.displacements.row(node);
        goal.nodes.push_back(node);
        goal.values.push_back({row[0], row[1], row[2]});
    }
    return {"hidden", "", {{goal}}};
}

inline design::DesignOptions design_options(const simulation::Project& project,
                                            const std::vector<std::string>& patterns = kDesignPatterns) {
    design::DesignOptions options;
    options.load_case = "cantilever";
    options.palette = pattern::parse_named_patterns(project.layout, patterns);
    options.threads = 1;
    return options;
}

}  // namespace fretwork::test
