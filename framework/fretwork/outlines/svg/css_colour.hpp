// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fretwork::outlines::detail {

/// A colour of CSS as "#rrggbb", without its opacity: hexadecimal, rgb() and names; nothing for others.
std::optional<std::string> css_colour(std::string_view text);

}  // namespace fretwork::outlines::detail
