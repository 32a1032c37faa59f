// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/painting/painting.hpp>

#include <span>
#include <vector>

namespace fretwork::tiling {

/// A pattern with the value of a quantity, such as the pattern's mass.
struct GradedPattern {
    pattern::NamedPattern pattern;  ///< the pattern
    double value = 0.0;             ///< the value of the quantity
};

/// The way in which a tile passes its error on to neighbours that are not painted yet. The error is the
/// wanted value (within the patterns' range) plus the errors received, minus the pattern's value.
enum class Dithering {
    None,           ///< each tile is painted by itself
    ErrorDiffusion  ///< the error is passed on
};

/// A painting of the listed tiles, in order, with the patterns that have the values nearest to the wanted
/// values. Entry k of `wanted` and of Painting::tiles is for tile k of the list.
///
/// Error diffusion [FloydSteinberg1976] on tiles: the neighbours that come later in the order share a tile's
/// error equally; if a tile has no such neighbour, the next tile in the order gets the error. With error
/// diffusion, the mean value of the painting is nearly the mean of the wanted values, each limited to the
/// range of the patterns. Throws InputError if there are no patterns, or if the numbers of values and tiles
/// differ.
Painting graded_painting(const Tessellation& tessellation, std::span<const TileIndex> tiles,
                         std::span<const GradedPattern> patterns, std::span<const double> wanted,
                         Dithering dithering);

}  // namespace fretwork::tiling
