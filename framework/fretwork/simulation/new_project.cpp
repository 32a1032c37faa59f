// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/new_project.hpp>

namespace fretwork::simulation {
namespace {

pattern::NodeLayout chosen_layout(const NewProjectOptions& options, const library::Library* library) {
    if (!library) return pattern::find_node_layout(options.layout.empty() ? "paper7" : options.layout);
    if (!options.layout.empty()) library->check_layout(pattern::find_node_layout(options.layout));
    return library->layout();
}

}  // namespace

NewProject make_project(const tiling::Outline& outline, const NewProjectOptions& options,
                        const library::Library* library) {
    check(options.painting);
    NewProject made;
    made.project.layout = chosen_layout(options, library);
    made.project.outline = outline;
    const reduction::Setting setting = library ? library->setting() : reduction::paper_setting();
    made.edge_length = options.edge_length.value_or(setting.tile_side);
    tiling::TessellationResult result = tiling::tessellate(
        outline, made.project.layout, {.edge_length = made.edge_length, .control = options.control});
    made.report = result.report;
    made.project.tessellation = std::move(result.tessellation);
    paint(made.project.tessellation, options.painting, made.project.layout, library);
    return made;
}

}  // namespace fretwork::simulation
