// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/regions/filled_region.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fretwork::outlines::detail {

/// The filled shapes of an SVG, in the order in which they are painted, with their colours: "#rrggbb", or ""
/// for a gradient.
struct ColouredPicture {
    Picture picture;
    std::vector<std::string> colours;
};

/// Read the filled shapes of an SVG file. Throws as read_outline_file.
ColouredPicture read_svg_colours(const std::filesystem::path& path);

}  // namespace fretwork::outlines::detail
