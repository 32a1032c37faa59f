// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/painting/painting.hpp>

#include <span>
#include <vector>

namespace fretwork::tiling {

/// A pattern and its value of some quantity, such as its mass.
struct GradedPattern {
    pattern::NamedPattern pattern;  ///< what is painted
    double value = 0.0;             ///< where it belongs along the palette
};

/// The choice whether a tile passes its error, the wanted value minus the pattern's value, to its neighbours
/// that are not painted yet.
enum class Dithering { None, ErrorDiffusion };

/// Paint some tiles, in order, with the patterns whose values are nearest to the wanted ones.
///
/// Error diffusion [FloydSteinberg1976] on tiles: the later tiles beside a tile share its error equally; if
/// there are none, the next tile gets it. The mean of the painting is then the mean of the wanted values, as
/// far as the range of the patterns allows. Throws InputError if there are no patterns or not as many values
/// as tiles.
Painting graded_painting(const Tessellation& tessellation, std::span<const TileIndex> tiles,
                         std::span<const GradedPattern> patterns, std::span<const double> wanted,
                         Dithering dithering);

}  // namespace fretwork::tiling
