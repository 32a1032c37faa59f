// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/rule.hpp>
#include <fretwork/pattern/search/independent_sets.hpp>

#include <optional>

namespace fretwork::pattern::detail {

/// C(n, k); 0 where k > n.
GraphCount binomial(int n, int k);

/// How many graphs of each size keep one rule, counted without walking them: conflicts by independent sets,
/// capacities by a table of loads, covers by inclusion and exclusion. None where that would take too much
/// memory, or the form of the rule allows no such count.
std::optional<CountsBySize> count_graphs_that_keep(const Rule& rule, int edge_count);

}  // namespace fretwork::pattern::detail
