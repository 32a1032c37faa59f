// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/space/bar_scene.hpp>

#include <cstdint>
#include <vector>

namespace fretwork::exports::detail {

/// How high the strip is that a picture of this size keeps free at its bottom for a legend; 0 if it is too
/// small for one.
int legend_height(PixelSize size);

/// A picture (red, green, blue and opacity, a byte each) of this size, in whose strip is a legend: the
/// field's title, its unit, the colours, the values at both ends, and the largest of those beyond with their
/// colour. Letters have a white rim, and the rest of the strip is transparent: they are read on any ground.
/// @param pixels  of the picture above the strip
std::vector<std::uint8_t> with_legend(std::vector<std::uint8_t> pixels, PixelSize size,
                                      const BarScene::Field& field);

}  // namespace fretwork::exports::detail
