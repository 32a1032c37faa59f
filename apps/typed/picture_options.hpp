// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/surface_drawing.hpp>
#include <fretwork/exports/scene.hpp>

#include <string>

namespace fretwork::typed {

/// From where somebody looks, as people write it: iso, front, right, back, left, top, or "AZIMUTH,ELEVATION"
/// in degrees. Throws InputError.
exports::ViewOptions parse_view(const std::string& text);

/// A picture's size as people write it: "1600x1000", each from 16 to 8000. Throws InputError.
exports::PixelSize parse_size(const std::string& text);

}  // namespace fretwork::typed
