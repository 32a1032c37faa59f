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

/// The height, in pixels, of the strip for a legend at the bottom of a picture of this size; 0 if the picture
/// is narrower or lower than 300 pixels. The strip is lower than a third of the picture.
int legend_height(PixelSize size);

/// A picture (red, green, blue and opacity, a byte each) of this size with a legend in its strip. The legend
/// shows the field's title with its unit, the colours with values below them, the largest value beyond the
/// range with its colour, and the note. Letters have a grey that is legible on white and on black. The rest
/// of the strip is transparent. Without a strip (legend_height() is 0), the result is `pixels`.
/// @param pixels  of the picture above the strip
std::vector<std::uint8_t> with_legend(std::vector<std::uint8_t> pixels, PixelSize size, const Legend& legend);

}  // namespace fretwork::exports::detail
