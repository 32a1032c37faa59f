// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/painting_options.hpp"
#include "output.hpp"

#include <fretwork/simulation/project/painting_recipe.hpp>

namespace fretwork::app {

void add_painting_options(CLI::App& verb, typed::PaintingText& text) {
    verb.add_option("--patterns", text.patterns,
                    "Patterns to paint with:\n"
                    "  ID: one pattern\n"
                    "  FILE.json: a painting file\n"
                    "  random:SEED: patterns of the palette at random\n"
                    "  field:EXPRESSION: an expression with values from 0 to 1 selects the pattern along the "
                    "palette; it has x and y (metres), or u and v (0 to 1 across the surface), such as "
                    "field:u or field:sin(30*x)^2\n"
                    "  image:FILE.png: the darkness of an image, stretched over the surface, selects the "
                    "pattern along the palette\n"
                    "  colours:FILE.svg: the colour at the middle of the tile, in a drawing with the "
                    "coordinates of the outline, selects the pattern")
        ->type_name("CHOICE");
    verb.add_option("--palette", text.palette,
                    "Patterns to choose from: ids joined by commas, or a painting file (default: the "
                    "calibrated patterns of the library). random also takes weights: ID=3,ID=1. colours "
                    "takes a pattern for each colour: red=ID,#00f=ID");
    verb.add_option(
            "--property", text.property,
            "For field and image: property of the patterns that follows the field or the darkness, such as "
            "bending_stiffness, membrane_stiffness or mass_per_area (default: the palette's order)")
        ->type_name("NAME");
    verb.add_option("--range", text.range,
                    "Values of --property (SI) where the field is 0 and where it is 1, such as 0.02,0.1 "
                    "(default: the palette's smallest and largest)")
        ->type_name("LOW,HIGH");
    verb.add_flag("--dither", text.dither,
                  "For field and image: mix patterns so that their mean follows the field");
}

base::InputError with_option_name(base::InputError error) {
    for (const char* entry : {"patterns", "palette", "property", "range", "library"})
        error = base::renamed(error, entry, std::string("--") + entry);
    return error;
}

void warn_of_unkept_file(const simulation::Project& project, const simulation::PaintingChoice& choice,
                         std::span<const tiling::TileIndex> painted) {
    if (const auto remark = simulation::unkept_file_remark(project, choice, painted)) warn(*remark);
}

std::size_t unpainted_count(const tiling::Tessellation& tessellation) {
    std::size_t count = 0;
    for (const tiling::Tile& tile : tessellation.tiles) count += tile.pattern < 0 ? 1 : 0;
    return count;
}

}  // namespace fretwork::app
