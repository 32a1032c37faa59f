// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <optional>
#include <vector>

namespace fretwork::simulation {

/// Options of new_tiles().
struct RetilingOptions {
    double edge_length = 0.0;       ///< wanted mean side of the new tiles, m
    std::optional<double> angle{};  ///< of the rows of tiles, rad; none: the most regular tiling
    /// The node layout of the new tiles. None: the layout of the project.
    std::optional<pattern::NodeLayout> layout{};
    base::Control control{};  ///< progress and stop
};

/// Tiles that cover the outline of a project, without patterns.
struct NewTiles {
    pattern::NodeLayout layout = pattern::paper_layout();  ///< layout of the interface nodes
    tiling::Tessellation tessellation;                     ///< tiles, not painted
    tiling::TessellationReport report;                     ///< measures of the tiles
    double largest_side = 0.0;                             ///< length of the longest side, m
};

/// Tile the outline of a project again, with tiling_options(). The project is not changed, and its present
/// tiles have no effect. Throws as tiling::tessellate().
NewTiles new_tiles(const Project& project, const RetilingOptions& options);

/// The entries of load cases that select interface nodes by number. The numbers mean other places on other
/// tiles, so these entries are left out.
struct DroppedEntries {
    int supports = 0;    ///< number of supports
    int loads = 0;       ///< number of loads, on nodes and on areas
    int prescribed = 0;  ///< number of prescribed displacements; components of one entry count once
};

/// A project on other tiles.
struct CarriedOver {
    Project project;  ///< the project with new tiles, and the parts of the old one that have a place on them
    /// For each new tile the old tile whose centroid is nearest; of several the one with the smallest number.
    base::IndexVector<tiling::TileIndex, tiling::TileIndex> from;
    DroppedEntries dropped;  ///< entries of load cases that were left out
};

/// Put new tiles into a project. By place: each tile takes the pattern and the tile model of the old tile
/// whose centroid is nearest, and a load on tiles goes to the new tiles that come from these tiles. Supports
/// and loads by side, box, nearest points and along the rim are kept as they are. With another layout all
/// tiles are left without a pattern, because its patterns are others, and the link to the library goes. A
/// fan has the same bars if its tile is turned by a vertex, so new tiles are not turned.
///
/// Throws InputError, with the load case and the entry, if an entry selects no node of the new tiles.
CarriedOver carry_over(const Project& project, const NewTiles& tiles);

}  // namespace fretwork::simulation
