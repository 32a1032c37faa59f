// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/surface_drawing.hpp>
#include <fretwork/exports/scene.hpp>

#include <string>

namespace fretwork::typed {

/// Read a view as a person writes it: iso, front, right, back, left, top, or "AZIMUTH,ELEVATION" in degrees.
/// Throws InputError.
exports::ViewOptions parse_view(const std::string& text);

/// A factor on displacements as it is given. Throws InputError if its magnitude is above 1e9, or if it is no
/// number.
double checked_scale(double scale);
/// Read a factor on displacements, from -1e9 to 1e9. Throws InputError.
double parse_scale(const std::string& text);

/// Read a picture's size in pixels, such as "1600x1000"; each number is from 16 to 8000. Throws InputError.
exports::PixelSize parse_size(const std::string& text);

}  // namespace fretwork::typed
