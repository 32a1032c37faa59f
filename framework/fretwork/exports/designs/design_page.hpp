// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>

#include <string>
#include <vector>

namespace fretwork::exports {

/// A self-contained HTML page that shows a design in any browser: the bent surface over the wanted surface,
/// its errors beside the errors of the best single pattern, the painting, the course of the search, the
/// reached and the wanted curvatures, and the limits of the result. The page is made from design.html, which
/// is built into the library.
std::string design_html(const design::DesignReport& report, const design::Target& target);

/// The reasons, one sentence each, why a design does not come nearer to the target, as far as the report
/// shows them.
std::vector<std::string> design_limits(const design::DesignReport& report);

}  // namespace fretwork::exports
