// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/new_project.hpp>

namespace fretwork::simulation {
namespace {

pattern::NodeLayout chosen_layout(const NewProjectOptions& options, const library::Library* library) {
    if (!library) return pattern::find_node_layout(options.layout.empty() ? "paper7" : options.layout);
    if (!options.layout.empty()) library->check_layout(pattern::find_node_layout(options.layout));
    return library->layout();
}

/// The options are checked before, so that what is refused is the outline.
tiling::TessellationResult tessellate_named(const tiling::Outline& outline, const std::string& name,
                                            const pattern::NodeLayout& layout,
                                            const tiling::TessellationOptions& options) {
    options.validate();
    if (name.empty()) return tiling::tessellate(outline, layout, options);
    try {
        return tiling::tessellate(outline, layout, options);
    } catch (const base::GeometryError& error) {
        throw base::GeometryError(name, "", error.what());
    } catch (const base::InputError& error) {
        throw base::InputError(name, "", error.what());
    }
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
    tiling::TessellationResult result =
        tessellate_named(outline, options.outline_name, made.project.layout,
                         {.edge_length = made.edge_length, .control = options.control});
    made.report = result.report;
    made.project.tessellation = std::move(result.tessellation);
    paint(made.project.tessellation, options.painting, made.project.layout, library);
    return made;
}

}  // namespace fretwork::simulation
