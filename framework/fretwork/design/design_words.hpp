// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/design_warning.hpp>

#include <string_view>
#include <vector>

namespace fretwork::design {

/// The reason why a search ended, as the words after "the design ended:".
std::string_view design_end_words(DesignEnd end);

/// The reasons why a design falls short, in this order: loads that do not fit the target, warnings of the
/// search, a target out of reach, and limits of the options that no checked painting keeps.
std::vector<DesignWarning> design_warnings(const DesignReport& report, const DesignOptions& options);

}  // namespace fretwork::design
