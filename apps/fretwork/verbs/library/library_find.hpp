// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>

namespace fretwork::app {

/// Print the patterns that a query finds, as a table or as JSON. Throws InputError that names the option with
/// the invalid expression.
void print_found(const library::Library& library, const library::PatternQuery& query, bool as_json);

}  // namespace fretwork::app
