// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// The source of the tiles of a new project.
enum class TilesFrom {
    Outline,  ///< new tiles that cover the outline
    Mesh,     ///< the faces of the outline file, which is a flat mesh
};

/// Options of make_project().
struct NewProjectOptions {
    /// The outline's file; if not empty, messages about the outline begin with it.
    std::string outline_name{};
    std::optional<double> edge_length{};   ///< m, wanted mean side of the tiles; none: the setting's tile
                                           ///< side
    TilesFrom tiles = TilesFrom::Outline;  ///< made from the outline, or the faces of a mesh
    tiling::Narrow narrow = tiling::Narrow::Refine;  ///< treatment of an outline that is narrower than a tile
    std::string layout{};                            ///< a name or a file; empty: the library's, or paper7
    std::optional<pattern::NodeLayout> own_layout{};  ///< the layout itself, whatever `layout` says
    /// Material, section and joints. None: the library's setting, or reduction::made_setting().
    std::optional<reduction::Setting> setting{};
    PaintingChoice painting{};  ///< how tiles are painted
    base::Control control{};    ///< how the caller follows and stops the work
};

/// A project without load cases, and the report about its tiling.
struct NewProject {
    Project project;                    ///< with its tessellation and painting
    tiling::TessellationReport report;  ///< how regular the tiles are
    double edge_length = 0.0;           ///< m, the wanted side; for a mesh, the mean side of its faces
};

/// Tile an outline and paint it. No side of a tile is shorter than the width of the setting's bars in the
/// plane, or than a quarter of the wanted side if that is less. `library` may be null; the project takes its
/// setting but no link to it. Throws as tiling::tessellate, with the outline's name, and as paint; InputError
/// if the library has another layout or setting.
NewProject make_project(const outlines::Outline& outline, const NewProjectOptions& options,
                        const library::Library* library);
/// Tile several separate outlines, part after part, as one tessellation, and paint it.
NewProject make_project(const std::vector<outlines::Outline>& parts, const NewProjectOptions& options,
                        const library::Library* library);

}  // namespace fretwork::simulation
