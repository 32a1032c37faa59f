// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fretwork::outlines::detail {

/// Replace the entities that a document declares (`<!DOCTYPE svg [ <!ENTITY st0 "fill:none"> ]>`) by their
/// text. Some drawing programs write them, and pugixml does not replace them. Line numbers stay. Entities in
/// other files are left unchanged. Throws InputError if the text would become far too long, if millions
/// of entities would be replaced, or if entities lie more than 16 deep in one another.
std::string with_entities_replaced(std::string text);

}  // namespace fretwork::outlines::detail
