// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace fretwork::library::detail {

/// The order of the enumeration among patterns of one number of edges, from their ids alone: the numbers in
/// the ids are compared in turn. It is that of comes_before(), without reading a pattern.
bool id_comes_before(std::string_view left, std::string_view right);

}  // namespace fretwork::library::detail
