// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/search.hpp>

namespace fretwork::design::detail {

/// Find the best values of the unknowns for a fixed painting by at most `steps` Gauss-Newton steps. Each step
/// is halved until it lowers the misfit. The method ends if no step lowers the misfit, or if the solutions
/// are used up. Throws Stopped.
Solved fit_unknowns(Trials& trials, Solved start, const DesignOptions& options, int steps);

/// Fit the unknowns of the most promising uniform paintings, in the order of `starts`, so that designs and
/// single patterns have the same freedom. Afterwards, `starts` is sorted again.
void fit_starts(Trials& trials, std::vector<Solved>& starts, const DesignOptions& options);

}  // namespace fretwork::design::detail
