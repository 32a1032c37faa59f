// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fretwork::outlines::detail {

/// Replace the entities that a document declares itself (`<!DOCTYPE svg [ <!ENTITY st0 "fill:none"> ]>`, as
/// some drawing programs write them) by their text; pugixml does not. Lines keep their numbers. Entities in
/// other files are left as they are. Throws InputError if the text would grow beyond all measure, or an
/// entity contains itself.
std::string with_entities_replaced(std::string text);

}  // namespace fretwork::outlines::detail
