// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/checks/designed_project.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::design::detail {
namespace {

/// Whether two settings have bars of the same width and thickness, up to rounding.
bool has_same_bars(const reduction::Setting& left, const reduction::Setting& right) {
    constexpr double kRounding = 1e-12;
    const auto is_same = [&](double (*size)(const mechanics::Section&)) {
        const double other = size(right.section);
        return std::abs(size(left.section) - other) <= kRounding * other;
    };
    return is_same(mechanics::rectangle_width) && is_same(mechanics::rectangle_height);
}

/// If the width or thickness of the bars has changed, the project has its own setting and no library, because
/// the library has the old section.
void write_section(const Trials& trials, const Point& point, DesignReport& report) {
    const auto& free = trials.parts().free;
    if (!free.width && !free.thickness) return;
    const reduction::Setting setting = trials.setting_at(point);
    report.width = mechanics::rectangle_width(setting.section);
    report.thickness = mechanics::rectangle_height(setting.section);
    if (has_same_bars(setting, trials.parts().surface.setting)) return;
    report.project.setting = setting;
    if (report.project.library_path.empty()) return;
    report.project.library_path.clear();
    report.project.library_hash.clear();
    report.warnings.push_back(
        {"the designed project names no library: its bars have another section than the library's"});
}

/// The tiles with another pattern than before leave the recipes of the painting.
void write_painting(const tiling::Tessellation& designed, simulation::Project& project) {
    std::vector<tiling::TileIndex> changed;
    for (const tiling::TileIndex tile : designed.tiles.indices()) {
        const auto* before = tiling::pattern_of(project.tessellation, tile);
        const auto* now = tiling::pattern_of(designed, tile);
        const bool is_same = before != nullptr && now != nullptr && before->id == now->id;
        if (!is_same) changed.push_back(tile);
    }
    simulation::end_recipes(project, changed);
    project.tessellation = designed;
}

}  // namespace

void write_point(const Trials& trials, const Point& point, const std::vector<std::string>& names,
                 DesignReport& report) {
    simulation::Project& project = report.project;
    write_painting(trials.surface_at(point).tessellation, project);
    for (const pattern::NamedPattern& own : project.tessellation.patterns) report.patterns.push_back(own.id);
    std::ranges::sort(report.patterns);
    report.mass = trials.mass_of(point);
    report.load_cases = names;
    write_section(trials, point, report);
    const auto& free = trials.parts().free;
    for (std::size_t c = 0; c < names.size(); ++c) {
        const simulation::LoadCase& wanted = trials.parts().cases[c].load_case;
        const simulation::LoadCase own = trials.load_case_at(point, c);
        report.factors.push_back(free.factor ? trials.factor_at(point, c) : 1.0);
        if (own == wanted) continue;
        for (simulation::LoadCase& stored : project.load_cases) {
            if (stored.name == own.name) stored = own;
        }
    }
}

}  // namespace fretwork::design::detail
