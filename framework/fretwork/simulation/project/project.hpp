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

/// The one document that the command line and the studio share.
struct Project {
    pattern::NodeLayout layout = pattern::paper_layout();  ///< of the tessellation's patterns
    outlines::Outline outline;
    std::vector<outlines::Outline> further_outlines{};  ///< of a surface of several parts, the others
    tiling::Tessellation tessellation;                  ///< with its painting
    std::vector<LoadCase> load_cases;
    /// The setting of the patterns' library when the project was made, or that it was made with: so the
    /// project means the same without a library. None, as in older files: that of the library as it is, or
    /// the paper's.
    std::optional<reduction::Setting> setting{};
    /// Tiles with their own tile model.
    struct TileModelChoice {
        std::string model;  ///< a row of the catalogue
        std::vector<tiling::TileIndex> tiles;
    };
    std::vector<TileModelChoice> tile_models{};
    std::string library_path;  ///< relative to the project file; empty: none
    std::string library_hash;  ///< content hash of the library when the project was made
};

/// The load case of a name, with what it combines; "" is the only one there is. Throws InputError that lists
/// what there is, and as combined().
LoadCase find_load_case(const Project& project, const std::string& name);

/// The tile model of each tile, "" for tiles without their own; empty if no tile has one.
std::vector<std::string> models_by_tile(const Project& project);

}  // namespace fretwork::simulation
