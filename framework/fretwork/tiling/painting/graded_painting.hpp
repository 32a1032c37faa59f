// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/painting/painting.hpp>

#include <span>
#include <vector>

namespace fretwork::tiling {

/// A pattern and a number that belongs to it, such as its mass.
struct GradedPattern {
    pattern::NamedPattern pattern;
    double value = 0.0;
};

/// Whether the value that a tile's pattern misses is handed to its neighbours that are not painted yet.
enum class Dithering { None, ErrorDiffusion };

/// Paint some tiles with the patterns whose values are nearest to the wanted ones, in the order of the tiles.
///
/// Error diffusion [FloydSteinberg1976] on tiles: a tile's error is shared evenly by the later tiles beside
/// it, or goes to the next tile if there are none. So the mean of the painting is that of the wanted values,
/// as far as the patterns reach. Throws InputError if there are no patterns or not as many values as tiles.
Painting graded_painting(const Tessellation& tessellation, std::span<const TileIndex> tiles,
                         std::span<const GradedPattern> patterns, std::span<const double> wanted,
                         Dithering dithering);

}  // namespace fretwork::tiling
