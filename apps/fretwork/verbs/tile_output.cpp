// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/painting_options.hpp"
#include "verbs/tile_output.hpp"

#include <fretwork/base/named.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::app {

base::Json tiling_json(const tiling::TessellationReport& report, const simulation::Project& project) {
    std::optional<std::string> setting;
    std::optional<std::string> joints;
    if (project.setting) {
        setting = reduction::setting_name(*project.setting);
        joints = reduction::joints_name(project.setting->joints);
    }
    return {{"tiles", report.tiles},
            {"interface_nodes", project.tessellation.interface_nodes.size()},
            {"patterns", tiling::used_patterns(project.tessellation).size()},
            {"hexagon_share", report.hexagon_share},
            {"inner_hexagon_share", report.inner_hexagon_share},
            {"mean_side", report.mean_side},
            {"sd_side", report.sd_side},
            {"smallest_side", report.smallest_side},
            {"smallest_angle", report.smallest_angle},
            {"covered_share", report.covered_share},
            {"outside_share", report.outside_share},
            {"refined_share", report.refined_share},
            {"library", project.library_path},
            {"setting", base::or_null(setting)},
            {"joints", base::or_null(joints)},
            {"load_cases_kept", base::names_of(project.load_cases, &simulation::LoadCase::name)}};
}

void print_tiling(const tiling::TessellationReport& report, const simulation::Project& project) {
    const std::size_t patterns = tiling::used_patterns(project.tessellation).size();
    std::printf("%s, %zu interface nodes, %s in use\n",
                base::counted(static_cast<std::size_t>(report.tiles), "tile").c_str(),
                project.tessellation.interface_nodes.size(), base::counted(patterns, "pattern").c_str());
    std::printf("hexagons %.0f %% (away from the rim %.0f %%), mean side %.2f mm (+- %.2f, smallest %.2f)\n",
                100 * report.hexagon_share, 100 * report.inner_hexagon_share, 1e3 * report.mean_side,
                1e3 * report.sd_side, 1e3 * report.smallest_side);
    std::printf("covers %.2f %% of the outline\n", 100 * report.covered_share);
    if (report.refined_share > 0)
        std::printf("%.0f %% of the tiles are smaller, because the outline is narrow near them\n",
                    std::max(1.0, 100 * report.refined_share));
    const std::size_t unpainted = unpainted_count(project.tessellation);
    if (unpainted > 0 && patterns > 0) std::printf("not painted yet: %zu\n", unpainted);
    if (!project.load_cases.empty())
        std::printf("the project keeps its load cases: %zu\n", project.load_cases.size());
}

}  // namespace fretwork::app
