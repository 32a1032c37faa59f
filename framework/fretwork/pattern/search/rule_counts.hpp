// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/pattern/rule.hpp>
#include <fretwork/pattern/search/independent_sets.hpp>

#include <optional>

namespace fretwork::pattern::detail {

/// The binomial coefficient C(n, k); 0 if k > n.
GraphCount binomial(int n, int k);

/// The number of graphs of each size that keep one rule, counted without walking them: conflicts by
/// independent sets, capacities by a table of loads, covers by inclusion and exclusion. None if the count
/// would take too much memory or time, if a capacity is above 100, or if no such count exists for the form
/// of the rule. Throws Stopped.
std::optional<CountsBySize> count_graphs_that_keep(const Rule& rule, int edge_count,
                                                   const base::Control& control = {});

}  // namespace fretwork::pattern::detail
