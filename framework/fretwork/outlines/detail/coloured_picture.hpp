// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/regions/filled_region.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fretwork::outlines::detail {

/// The filled shapes of an SVG, in the order in which they are painted, with their colours: "#rrggbb", or ""
/// for a gradient, a pattern or a colour that parse_colour() does not know.
struct ColouredPicture {
    Picture picture;
    std::vector<std::string> colours;
};

/// The filled shapes of the text of an SVG. `source` names the text in an InputError, but not in a
/// GeometryError.
ColouredPicture parse_svg_colours(std::string_view text, const std::string& source);

}  // namespace fretwork::outlines::detail
