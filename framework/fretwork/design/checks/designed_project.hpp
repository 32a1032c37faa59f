// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <string>
#include <vector>

namespace fretwork::design::detail {

/// Write the painting of a point, and its unknowns, into the project and the other fields of a report that
/// describe them.
/// @param names  names of the load cases
void write_point(const Trials& trials, const Point& point, const std::vector<std::string>& names,
                 DesignReport& report);

}  // namespace fretwork::design::detail
