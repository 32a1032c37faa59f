// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/outline.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// A project: the document that the command line and the studio share.
struct Project {
    pattern::NodeLayout layout = pattern::paper_layout();  ///< layout of the tessellation's patterns
    outlines::Outline outline;                             ///< outline of the first part
    /// Outlines of the other parts, if the surface has several.
    std::vector<outlines::Outline> further_outlines{};
    tiling::Tessellation tessellation;  ///< tiles with their painting
    std::vector<LoadCase> load_cases;   ///< load cases with distinct names
    /// The setting of the library when the project was made, or a chosen one. With it, results of tile models
    /// without calibrated parameters do not depend on the library (needs_library()). Older files have none:
    /// the present setting of the library is used or, without a library, the paper's setting.
    std::optional<reduction::Setting> setting{};
    /// A tile model for some tiles.
    struct TileModelChoice {
        std::string model;                     ///< name of the tile model
        std::vector<tiling::TileIndex> tiles;  ///< tiles with this tile model
    };
    std::vector<TileModelChoice> tile_models{};  ///< tile models of tiles that have their own
    /// Recipes of tiles that were painted by place or by chance; a tile has one at most. Tiles painted in
    /// other ways (by hand, from a painting file, by a design) or from an image or drawing of more than
    /// kLargestKeptFile bytes have none. The patterns of all tiles are in the tessellation.
    std::vector<PaintingRecipe> recipes{};
    /// Path of the library relative to the project file; empty: no library.
    std::string library_path;
    std::string library_hash;  ///< content hash of the library when the project was made
};

/// The load case with this name, merged with the load cases that it combines. If the name is "", the only
/// load case of the project is taken. Throws InputError if no load case has this name, or if the name is ""
/// and the project has none or several. Throws as combined().
LoadCase find_load_case(const Project& project, const std::string& name);

/// The name of each tile's own tile model, "" for tiles without one. The vector is empty if
/// Project::tile_models is empty. Throws InputError if a tile is not there.
std::vector<std::string> models_by_tile(const Project& project);
/// The inverse of models_by_tile(): each model with its tiles, sorted by the models' names.
std::vector<Project::TileModelChoice> tile_model_choices(const std::vector<std::string>& models);

}  // namespace fretwork::simulation
