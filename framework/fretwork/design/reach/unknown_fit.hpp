// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/search.hpp>

namespace fretwork::design::detail {

/// Find the best values of the unknowns besides the painting, while the painting stays. The method makes at
/// most `steps` Gauss-Newton steps, each of which is halved until it lowers the misfit. The method ends if no
/// step lowers the misfit, or if the solutions are spent. Throws Stopped.
Solved fit_unknowns(Trials& trials, Solved start, const DesignOptions& options, int steps);

/// Give the most promising of some uniform paintings, in the order of `starts`, their own best unknowns, so
/// that a design is compared with single patterns of the same freedom. Afterwards, `starts` is sorted again.
void fit_starts(Trials& trials, std::vector<Solved>& starts, const DesignOptions& options);

}  // namespace fretwork::design::detail
