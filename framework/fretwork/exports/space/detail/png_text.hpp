// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/detail/raster.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace fretwork::exports::detail {

/// A PNG file of red, green, blue and opacity, a byte each, row by row from the upper left.
std::string png_text(PixelSize size, const std::vector<std::uint8_t>& bytes);

}  // namespace fretwork::exports::detail
