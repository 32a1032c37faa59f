// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>

#include <string>
#include <vector>

namespace fretwork::exports {

/// Make a self-contained HTML page about a design. It shows the bent surface and the target, the errors
/// beside those of the best single pattern, the painting, the progress of the search, reached and wanted
/// curvatures, and the limits of the result. The template design.html is built into the library.
std::string design_html(const design::DesignReport& report, const design::Target& target);

/// The limits of a design in words: how the search ended, what keeps the design from the target, and the
/// warnings of the report.
std::vector<std::string> design_limits(const design::DesignReport& report);

}  // namespace fretwork::exports
