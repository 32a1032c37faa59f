// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/bar_scene.hpp>
#include <fretwork/exports/colours.hpp>

#include <cstdint>
#include <vector>

namespace fretwork::exports::detail {

/// A picture of pixels (red, green, blue and opacity, a byte each) with a legend in its lower left corner:
/// the field's title, its unit, the colours, the values at both ends, and the largest of those beyond with
/// their colour. Pictures too small for it stay as they are.
std::vector<std::uint8_t> with_legend(std::vector<std::uint8_t> pixels, PixelSize size,
                                      const BarScene::Field& field);

}  // namespace fretwork::exports::detail
