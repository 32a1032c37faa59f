// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/pattern.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::reduction {

/// Choose up to `size` items. Each stratum gives the same number of items (the strata with the lowest numbers
/// may give one more); a stratum with fewer items gives all of them. The chosen items are evenly spread
/// within their stratum. Returns ascending indices. The choice is deterministic.
/// @param strata  the number of each item's stratum
std::vector<std::size_t> stratified_sample(std::span<const int> strata, std::size_t size);

/// Choose up to `size` patterns by stratified_sample() and keep their order. Patterns with the same number of
/// edges form a stratum.
std::vector<pattern::Pattern> spread_over_edges(std::span<const pattern::Pattern> patterns, std::size_t size);

}  // namespace fretwork::reduction
