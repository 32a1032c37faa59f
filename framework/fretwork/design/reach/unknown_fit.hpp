// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/search.hpp>

namespace fretwork::design::detail {

/// Fit the unknowns of the most promising of the uniform paintings `starts`, judged by their scaled
/// objective, so that designs and single patterns have the same freedom. Sort `starts`, the best first; those
/// that keep DesignOptions::max_mass come before all others. The fit ends early if the solutions of `options`
/// or three fifths of the time are used up. Throws Stopped.
void fit_starts(Trials& trials, std::vector<Solved>& starts, const DesignOptions& options,
                const TimeLimit& time);

}  // namespace fretwork::design::detail
