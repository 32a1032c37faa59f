// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace fretwork::library::detail {

/// True if the left id comes before the right one in the order of comes_before(), for patterns with the same
/// number of edges. The numbers in the ids are compared one by one; the ids are not parsed into patterns.
bool id_comes_before(std::string_view left, std::string_view right);

}  // namespace fretwork::library::detail
