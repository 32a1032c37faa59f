// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <string>
#include <vector>

namespace fretwork::design::detail {

/// Write the painting and the unknowns of a point into the report's project and into the report's fields
/// about them. If the section of the bars has changed, the project gets its own setting and loses its
/// library, with a warning.
/// @param names  names of the load cases
void write_point(const Trials& trials, const Point& point, const std::vector<std::string>& names,
                 DesignReport& report);

}  // namespace fretwork::design::detail
