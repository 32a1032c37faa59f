// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/space/bar_scene.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace fretwork::exports::detail {

/// The content of a legend.
struct Legend {
    const BarScene::Field& field;
    const std::string& note;  ///< a line below
};

/// How high the strip is that a picture of this size keeps free at its bottom for a legend; 0 if it is too
/// small for one.
int legend_height(PixelSize size);

/// A picture (red, green, blue and opacity, a byte each) of this size, in whose strip is a legend: the
/// field's title with its unit, the colours with values below them, the largest of the values beyond with
/// their colour, and the note. Letters are of a grey that is read on white and on black, and the rest of the
/// strip is transparent.
/// @param pixels  of the picture above the strip
std::vector<std::uint8_t> with_legend(std::vector<std::uint8_t> pixels, PixelSize size, const Legend& legend);

}  // namespace fretwork::exports::detail
