// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/outline.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// A project: the document that the command line and the studio share.
struct Project {
    pattern::NodeLayout layout = pattern::paper_layout();  ///< layout of the tessellation's patterns
    outlines::Outline outline;                             ///< the first part
    std::vector<outlines::Outline> further_outlines{};     ///< the outlines of the further parts of a surface
                                                           ///< with several parts
    tiling::Tessellation tessellation;                     ///< with its painting
    std::vector<LoadCase> load_cases;                      ///< names differ
    /// The setting at the time when the project was made, from its library or chosen for it. With it, the
    /// project means the same without the library. None, as in older files: the present setting of the
    /// library, or the paper's.
    std::optional<reduction::Setting> setting{};
    /// Tiles with their own tile model.
    struct TileModelChoice {
        std::string model;                     ///< a row of the catalogue
        std::vector<tiling::TileIndex> tiles;  ///< which have it
    };
    std::vector<TileModelChoice> tile_models{};  ///< tiles with a model of their own
    std::string library_path;                    ///< path relative to the project file; empty: no library
    std::string library_hash;                    ///< content hash of the library when the project was made
};

/// The load case with this name, merged with those that it combines. "" means the project's only load case.
/// Throws InputError that lists the names, and as combined().
LoadCase find_load_case(const Project& project, const std::string& name);

/// The tile model of each tile, "" for tiles without their own; empty if no tile has one.
std::vector<std::string> models_by_tile(const Project& project);

}  // namespace fretwork::simulation
