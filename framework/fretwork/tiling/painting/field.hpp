// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/painting/tile_choice.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::tiling {

/// The values of an expression, such as "u", "sin(20*x)^2" or "x > 0.1 ? 1 : 0", at some points. The
/// variables are `x` and `y` (m), and `u` and `v`, which run from 0 to 1 across the box. The constant `pi`
/// and the functions of muParser are known. Throws InputError that says what is wrong with the expression, or
/// names a point at which its value is not finite. Without points, the expression is only checked.
std::vector<double> expression_values(const std::string& expression, const geometry::Box& box,
                                      const std::vector<geometry::Point2>& points);

/// The darkness of a PNG image, stretched over the box, at some points: 0 is white, 1 is black. It is one
/// minus the grey value as encoded in sRGB, which images without a gamma are taken to be, with 8 bits or 16.
/// The ground is white: a pixel of opacity a and darkness d counts as a d, so transparent counts as white.
/// Throws InputError if the image cannot be read, or if a corner of the box or a point, which is named by its
/// place in the list, is beyond the limits of lengths or not a number.
std::vector<double> image_values(const std::filesystem::path& image, const geometry::Box& box,
                                 const std::vector<geometry::Point2>& points);
/// The same for a PNG image in memory; `source` names it in messages.
std::vector<double> image_values(std::string_view png, const std::string& source, const geometry::Box& box,
                                 const std::vector<geometry::Point2>& points);

}  // namespace fretwork::tiling
