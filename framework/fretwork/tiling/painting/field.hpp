// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/painting/tile_choice.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::tiling {

/// The values of an expression of `x` and `y` (m), and of `u` and `v` (the same from 0 to 1 across the box)
/// at some points: "u", "sin(20*x)^2", "x > 0.1 ? 1 : 0". Its functions are those of muParser. Throws
/// InputError that says where the expression cannot be read, or where its value is not finite.
std::vector<double> expression_values(const std::string& expression, const geometry::Box& box,
                                      const std::vector<geometry::Point2>& points);

/// How dark a PNG image is at some points, when it is stretched over the box: 0 white, 1 black; what is
/// transparent counts as white. Throws InputError if it cannot be read.
std::vector<double> image_values(const std::filesystem::path& image, const geometry::Box& box,
                                 const std::vector<geometry::Point2>& points);

}  // namespace fretwork::tiling
