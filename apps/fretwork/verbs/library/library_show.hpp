// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>

namespace fretwork::app {

/// Print all that a library has of one pattern, for people or for programs.
void print_pattern(const library::Library& library, const pattern::NamedPattern& entry);
void print_pattern_json(const library::Library& library, const pattern::NamedPattern& entry);

}  // namespace fretwork::app
