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

/// Where the tiles of a new project come from.
enum class TilesFrom {
    Outline,  ///< the outline is covered with new ones
    Mesh,     ///< the faces of the flat mesh that is named as the outline
};

/// How an outline becomes a project.
struct NewProjectOptions {
    /// The outline's file; if not empty, messages about the outline begin with it.
    std::string outline_name{};
    std::optional<double> edge_length{};  ///< m, wanted mean side of the tiles; none: the setting's tile
                                          ///< side
    TilesFrom tiles = TilesFrom::Outline;
    tiling::Narrow narrow = tiling::Narrow::Refine;  ///< what to do where the outline is narrower than a tile
    std::string layout{};                            ///< a name or a file; empty: the library's, or paper7
    /// Material, section and joints; none: the library's, or reduction::made_setting().
    std::optional<reduction::Setting> setting{};
    PaintingChoice painting{};
    base::Control control{};
};

/// A project without load cases, and how its tiling came out.
struct NewProject {
    Project project;
    tiling::TessellationReport report;
    double edge_length = 0.0;  ///< m, that was wanted; of a mesh, the mean side of its faces
};

/// Tile an outline and paint it. No side of a tile is shorter than the setting's bars are wide in the plane,
/// or than a quarter of the wanted side if that is less. `library` may be null; the project has its setting,
/// but is not linked with it. Throws as tiling::tessellate, with the outline's name, and paint; InputError if
/// the library is one of another layout or setting.
NewProject make_project(const outlines::Outline& outline, const NewProjectOptions& options,
                        const library::Library* library);
/// The same for outlines that lie apart: one tessellation, part after part.
NewProject make_project(const std::vector<outlines::Outline>& parts, const NewProjectOptions& options,
                        const library::Library* library);

}  // namespace fretwork::simulation
