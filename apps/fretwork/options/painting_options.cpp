// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/painting_options.hpp"

namespace fretwork::app {

void add_painting_options(CLI::App& verb, typed::PaintingText& text) {
    verb.add_option(
            "--patterns", text.patterns,
            "What to paint with:\n"
            "  ID: one pattern\n"
            "  FILE.json: a painting file\n"
            "  random:SEED: one of the palette by chance\n"
            "  field:EXPRESSION: along the palette by an expression that goes from 0 to 1, of x and y "
            "(metres) or u and v (0 to 1 across the surface), such as field:u or field:sin(30*x)^2\n"
            "  image:FILE.png: along the palette by how dark an image is, stretched over the surface\n"
            "  colours:FILE.svg: by the colour that a drawing has there, in the outline's coordinates")
        ->type_name("CHOICE");
    verb.add_option(
        "--palette", text.palette,
        "Patterns to choose from: ids with commas between, or a painting file (default: those that "
        "the library has calibrated); by chance with weights, ID=3,ID=1; by colours red=ID,#00f=ID");
    verb.add_option("--property", text.property,
                    "By field and image: the property whose values go with the field, such as "
                    "bending_stiffness, membrane_stiffness or mass_per_area (default: the palette's order)")
        ->type_name("NAME");
    verb.add_option("--range", text.range,
                    "The property's values (SI) where the field is 0 and 1, such as 0.02,0.1 (default: the "
                    "palette's least and largest)")
        ->type_name("LOW,HIGH");
    verb.add_flag("--dither", text.dither,
                  "By field and image: mix patterns so that their mean goes with the field");
}

base::InputError with_option_name(base::InputError error) {
    for (const char* entry : {"patterns", "palette", "property", "range", "library"})
        error = base::renamed(error, entry, std::string("--") + entry);
    return error;
}

std::size_t unpainted_count(const tiling::Tessellation& tessellation) {
    std::size_t count = 0;
    for (const tiling::Tile& tile : tessellation.tiles) count += tile.pattern < 0 ? 1 : 0;
    return count;
}

}  // namespace fretwork::app
