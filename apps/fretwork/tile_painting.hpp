// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <string>

namespace fretwork::app {

/// How `fretwork tile` is to paint.
struct PaintingOptions {
    std::string patterns;  ///< random:SEED, a painting file, or the id of one pattern; empty: no painting
    std::string
        palette;  ///< for random:SEED: a painting file, or ids with commas between; empty: the library's
};

/// Throws InputError where --palette is given and --patterns is not random:SEED.
void check(const PaintingOptions& options);

/// Paint as the options say. `library` may be null. Throws InputError.
void paint(tiling::Tessellation& tessellation, const PaintingOptions& options,
           const pattern::NodeLayout& layout, const library::Library* library);

}  // namespace fretwork::app
