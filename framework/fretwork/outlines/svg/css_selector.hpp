// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/svg/css.hpp>

#include <optional>

namespace fretwork::outlines::detail {

/// One selector of a list, without the commas; nothing if it has something that is not understood.
std::optional<CssSelector> parse_css_selector(std::string_view text);

/// Whether an element is chosen. Every compound that is looked at counts as one of `looks`. Throws InputError
/// after ten million of them.
bool matches(const CssSelector& selector, pugi::xml_node node, long& looks);

}  // namespace fretwork::outlines::detail
