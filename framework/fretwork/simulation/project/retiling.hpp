// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <optional>
#include <vector>

namespace fretwork::simulation {

/// Options of retile().
struct RetilingOptions {
    /// Wanted mean side of the new tiles, m. None: the mean side of the present tiles.
    std::optional<double> edge_length{};
    std::optional<double> angle{};  ///< angle of the rows of tiles, rad; none: the most regular
    tiling::Narrow narrow = tiling::Narrow::Refine;  ///< treatment of places narrower than a tile
    /// The node layout of the new tiles. None: the layout of the project.
    std::optional<pattern::NodeLayout> layout{};
    /// The way in which retile() paints the new tiles. Without one, patterns are carried over by place, and
    /// the recipes of the project are applied again; with colours, this is done first, because tiles beside
    /// the drawing keep their patterns.
    PaintingChoice painting{};
    base::Control control{};  ///< progress and stop
};

/// Tiles that cover the outline of a project, without patterns.
struct NewTiles {
    pattern::NodeLayout layout = pattern::paper_layout();  ///< layout of the interface nodes
    tiling::Tessellation tessellation;                     ///< tiles, not painted
    tiling::TessellationReport report;                     ///< measures of the tiles
};

/// Tile the outline of a project again, with tiling_options(). The project does not change. Throws as
/// tiling::tessellate().
NewTiles new_tiles(const Project& project, const RetilingOptions& options);

/// The numbers of load-case entries that are left out because they have no place on the new tiles. These
/// entries select interface nodes by number, and the interface nodes have changed; or they load tiles that no
/// new tile comes from.
struct DroppedEntries {
    int supports = 0;    ///< number of supports
    int loads = 0;       ///< number of loads, on nodes and on areas
    int prescribed = 0;  ///< number of prescribed displacements; all components of an entry count as one
};

/// A project on other tiles.
struct CarriedOver {
    Project project;  ///< the project with new tiles
    /// The old tile nearest to each new tile, by their centroids; the smallest number if there are several.
    base::IndexVector<tiling::TileIndex, tiling::TileIndex> from;
    DroppedEntries dropped;  ///< entries of load cases that were left out
};

/// Put new tiles into a project. Each new tile takes the pattern, the tile model and the recipe of the old
/// tile with the nearest centroid. A load on old tiles goes to the new tiles that come from them. Entries
/// that select nodes by side, box, circle, nearest points or along the rim are kept as they are. With another
/// layout, new tiles have neither pattern nor recipe, and the link to the library is removed. The first
/// vertices of the new tiles are kept, because a turn by a vertex does not change the bars of a fan.
///
/// Throws InputError, with the load case and the entry, if an entry has no place on the new tiles.
CarriedOver carry_over(const Project& project, const NewTiles& tiles);

/// The result of retile().
struct RetiledProject {
    Project project;                    ///< the project with new tiles
    tiling::TessellationReport report;  ///< measures of the new tiles
    DroppedEntries dropped;             ///< entries of load cases that were left out
    /// The old tile nearest to each new tile, as in CarriedOver.
    base::IndexVector<tiling::TileIndex, tiling::TileIndex> from;
    std::vector<tiling::TileIndex> painted;  ///< tiles that RetilingOptions::painting has painted
};

/// Cover the outline of a project with other tiles by new_tiles() and carry_over(). Then paint them by
/// `options.painting` or, without one, by apply_recipes(); with colours, by both. A painting finds patterns
/// and their properties in `library`, which may be null. Throws as these functions, and InputError if the
/// library has another layout than the new tiles.
RetiledProject retile(const Project& project, const RetilingOptions& options,
                      const library::Library* library);

}  // namespace fretwork::simulation
