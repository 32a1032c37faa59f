// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/search.hpp>

namespace fretwork::design::detail {

/// Find the best values of the unknowns for a fixed painting by at most `steps` Gauss-Newton steps. A step is
/// halved until it lowers the objective, at most three times. The fit ends if a step lowers the objective by
/// less than 0.1 %, or if the solutions are used up. Trial::is_found is false if the start, which is solved
/// again, is not found. Throws Stopped.
Solved fit_unknowns(Trials& trials, Solved start, const DesignOptions& options, int steps);

/// Fit the unknowns of the most promising of the uniform paintings `starts`, judged by their scaled
/// objective, so that designs and single patterns have the same freedom. Sort `starts`, the best first; those
/// that keep DesignOptions::max_mass come before all others. Throws Stopped.
void fit_starts(Trials& trials, std::vector<Solved>& starts, const DesignOptions& options);

}  // namespace fretwork::design::detail
