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
    /// The name of the outline's file, for the start of messages; may be empty. With TilesFrom::Mesh, the
    /// path of the mesh file, which is read.
    std::string outline_name{};
    /// Wanted mean side of the tiles, m; none: the setting's tile side.
    std::optional<double> edge_length{};
    std::optional<double> angle{};         ///< angle of the rows of tiles, rad; none: the most regular
    TilesFrom tiles = TilesFrom::Outline;  ///< source of the tiles
    tiling::Narrow narrow = tiling::Narrow::Refine;  ///< treatment of an outline that is narrower than a tile
    /// Name or file of the node layout; empty: the library's layout, or paper7.
    std::string layout{};
    std::optional<pattern::NodeLayout> own_layout{};  ///< the node layout itself, which replaces `layout`
    /// The setting. None: the library's setting or, without a library, reduction::made_setting().
    std::optional<reduction::Setting> setting{};
    PaintingChoice painting{};  ///< painting of the tiles
    base::Control control{};    ///< progress and stop
};

/// Options of tiles with a wanted mean side, m, and an angle of the rows, rad (none: the most regular). The
/// smallest side is mechanics::rectangle_width() of the setting's section, or a quarter of the wanted side if
/// this is smaller.
tiling::TessellationOptions tiling_options(const reduction::Setting& setting, double edge_length,
                                           std::optional<double> angle);

/// A project without load cases, and a report about its tiling.
struct NewProject {
    Project project;                         ///< the project, with tessellation and painting
    tiling::TessellationReport report;       ///< measures of the tiles
    double edge_length = 0.0;                ///< wanted side, m; for a mesh, the mean side of its faces
    std::vector<tiling::TileIndex> painted;  ///< tiles that NewProjectOptions::painting has painted
};

/// Tile an outline with tiling_options(), or take the tiles of a mesh, and paint them. `library` may be null;
/// the project takes the library's setting, but no link to the library. Throws as tiling::tessellate(), with
/// the outline's name, as tiling::read_mesh_tessellation(), and as paint(). Throws InputError if the layout
/// is unknown, or if the library has another layout or setting.
NewProject make_project(const outlines::Outline& outline, const NewProjectOptions& options,
                        const library::Library* library);
/// Tile several separate outlines, part by part, as one tessellation, and paint it. Throws as above, and
/// InputError if there is no part.
NewProject make_project(const std::vector<outlines::Outline>& parts, const NewProjectOptions& options,
                        const library::Library* library);

}  // namespace fretwork::simulation
