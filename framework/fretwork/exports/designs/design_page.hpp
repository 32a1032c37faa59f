// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>

#include <string>
#include <vector>

namespace fretwork::exports {

/// One HTML file that shows a design in any browser, and needs nothing besides: the bent surface over the
/// wanted one, its errors beside those of the best single pattern, the painting, the course of the search,
/// the curvatures that the load gives and the target asks for, and what limits the result. The page is
/// design.html, which is part of the library.
std::string design_html(const design::DesignReport& report, const design::Target& target);

/// What keeps a design from coming nearer, as far as the report knows it, one sentence each.
std::vector<std::string> design_limits(const design::DesignReport& report);

}  // namespace fretwork::exports
