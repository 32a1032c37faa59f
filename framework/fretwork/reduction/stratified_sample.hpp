// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/pattern.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::reduction {

/// Choose up to `size` items: equally many of each stratum until it is used up, evenly spread within it.
/// Returns ascending indices; deterministic.
std::vector<std::size_t> stratified_sample(std::span<const int> strata, std::size_t size);

/// Up to `size` of these patterns, spread over the numbers of edges, in their order.
std::vector<pattern::Pattern> spread_over_edges(std::span<const pattern::Pattern> patterns, std::size_t size);

}  // namespace fretwork::reduction
