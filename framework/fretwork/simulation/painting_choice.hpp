// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <string>

namespace fretwork::simulation {

/// How a new surface is to be painted, as people write it.
struct PaintingChoice {
    std::string patterns;  ///< random:SEED, a painting file, or the id of one pattern; empty: no painting
    std::string
        palette;  ///< for random:SEED: a painting file, or ids with commas between; empty: the library's
    /// What these, and the library, are called where people write them: for messages.
    struct Names {
        std::string patterns = "--patterns";
        std::string palette = "--palette";
        std::string library = "--library";
    } names{};
};

/// Throws InputError where a palette is given and the patterns are not random:SEED.
void check(const PaintingChoice& choice);

/// Paint as it is chosen. `library` may be null. Throws InputError that names what was chosen.
void paint(tiling::Tessellation& tessellation, const PaintingChoice& choice,
           const pattern::NodeLayout& layout, const library::Library* library);

}  // namespace fretwork::simulation
