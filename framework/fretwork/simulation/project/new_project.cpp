// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::simulation {
namespace {

pattern::NodeLayout chosen_layout(const NewProjectOptions& options, const library::Library* library) {
    std::optional<pattern::NodeLayout> wanted = options.own_layout;
    if (!wanted && !options.layout.empty()) wanted = pattern::find_node_layout(options.layout);
    if (!library) return wanted ? *std::move(wanted) : pattern::find_node_layout("paper7");
    if (wanted) library->check_layout(*wanted);
    return library->layout();
}

/// Checks the options first, so that later errors are about the outline.
tiling::TessellationResult tessellate_named(const std::vector<outlines::Outline>& parts,
                                            const std::string& name, const pattern::NodeLayout& layout,
                                            const tiling::TessellationOptions& options) {
    options.validate();
    if (name.empty()) return tiling::tessellate_parts(parts, layout, options);
    try {
        return tiling::tessellate_parts(parts, layout, options);
    } catch (const base::GeometryError& error) {
        throw base::within(name, "", error);
    } catch (const base::InputError& error) {
        throw base::within(name, "", error);
    }
}

tiling::TessellationResult new_tiles(const std::vector<outlines::Outline>& parts,
                                     const NewProjectOptions& options, const pattern::NodeLayout& layout,
                                     const reduction::Setting& setting) {
    tiling::TessellationOptions tiles =
        tiling_options(setting, options.edge_length.value_or(setting.tile_side), options.angle);
    tiles.narrow = options.narrow;
    tiles.control = options.control;
    return tessellate_named(parts, options.outline_name, layout, tiles);
}

}  // namespace

tiling::TessellationOptions tiling_options(const reduction::Setting& setting, double edge_length,
                                           std::optional<double> angle) {
    tiling::TessellationOptions options;
    options.edge_length = edge_length;
    options.smallest_side = std::min(mechanics::rectangle_width(setting.section), 0.25 * edge_length);
    options.angle = angle;
    return options;
}

NewProject make_project(const outlines::Outline& outline, const NewProjectOptions& options,
                        const library::Library* library) {
    return make_project(std::vector{outline}, options, library);
}

NewProject make_project(const std::vector<outlines::Outline>& parts, const NewProjectOptions& options,
                        const library::Library* library) {
    if (parts.empty()) throw base::InputError(options.outline_name, "", "has no part");
    NewProject made;
    made.project.layout = chosen_layout(options, library);
    made.project.outline = parts.front();
    made.project.further_outlines.assign(parts.begin() + 1, parts.end());
    made.project.setting = options.setting;
    if (!options.setting && !library) made.project.setting = reduction::made_setting();
    const reduction::Setting setting = setting_of(made.project, library);
    made.project.setting = setting;
    const bool is_mesh = options.tiles == TilesFrom::Mesh;
    tiling::TessellationResult result =
        is_mesh ? tiling::read_mesh_tessellation(options.outline_name, made.project.layout)
                : new_tiles(parts, options, made.project.layout, setting);
    made.edge_length = is_mesh ? result.report.mean_side : options.edge_length.value_or(setting.tile_side);
    made.report = result.report;
    made.project.tessellation = std::move(result.tessellation);
    made.painted = paint(made.project, options.painting, library);
    return made;
}

}  // namespace fretwork::simulation
