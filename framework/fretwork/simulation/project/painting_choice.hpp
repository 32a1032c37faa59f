// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>
#include <fretwork/tiling/painting/graded_painting.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <span>
#include <string>
#include <vector>

namespace fretwork::simulation {

/// How tiles are to be painted, as people write it.
struct PaintingChoice {
    /// One pattern's id, a painting file, `random:SEED`, `field:EXPRESSION` of x y (m) and u v (0 to 1 across
    /// the surface), `image:FILE.png` (white 0, black 1) or `colours:FILE.svg`; empty: no painting.
    std::string patterns;
    /// What is chosen from: a painting file, or ids with commas between; empty: the library's calibrated
    /// ones. With random:SEED an id may have a weight, `ID=3`; with colours:FILE.svg every id has its colour,
    /// `red=ID`.
    std::string palette;
    /// By field and image, the property of a library (`bending_stiffness`) whose values decide; empty: the
    /// order of the palette does.
    std::string property{};
    /// The property's values, SI, where the field is 0 and 1: `0.02,0.1`; empty: the palette's least and
    /// largest.
    std::string range{};
    tiling::Dithering dithering = tiling::Dithering::None;  ///< by field and image
    /// What these, and the library, are called where people write them: for messages.
    struct Names {
        std::string patterns = "--patterns";
        std::string palette = "--palette";
        std::string library = "--library";
        std::string property = "--property";
        std::string range = "--range";
        std::string dithering = "--dither";
    } names{};
};

/// Throws InputError where something is given that the patterns do not go with.
void check(const PaintingChoice& choice);

/// What patterns are of. `library` may be null.
struct PaintingGround {
    const pattern::NodeLayout& layout;
    const reduction::Setting& setting;
    const library::Library* library = nullptr;
};

/// Paint all tiles as it is chosen. Throws InputError that names what was chosen.
void paint(tiling::Tessellation& tessellation, const PaintingChoice& choice, const PaintingGround& ground);
/// The same for some tiles; the others keep theirs. By chance and field the tiles are painted in this order.
/// Of a painting file each takes what it has for that tile. With colours, tiles on none of the palette's
/// colours keep theirs. Returns the tiles that were painted.
std::vector<tiling::TileIndex> paint(tiling::Tessellation& tessellation,
                                     std::span<const tiling::TileIndex> tiles, const PaintingChoice& choice,
                                     const PaintingGround& ground);

/// Replace the patterns of some tiles by their mirror images. Throws InputError that names a pattern whose
/// mirror image the layout does not have, or a tile that is not painted.
void mirror(tiling::Tessellation& tessellation, std::span<const tiling::TileIndex> tiles,
            const pattern::NodeLayout& layout);

}  // namespace fretwork::simulation
