// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace fretwork::library::detail {

/// True if the left id comes first in the order of the enumeration, for patterns with the same number of
/// edges. The numbers in the ids are compared one by one. The order is the order of comes_before(), but no
/// pattern is read.
bool id_comes_before(std::string_view left, std::string_view right);

}  // namespace fretwork::library::detail
