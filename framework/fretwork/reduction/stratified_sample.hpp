// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::reduction {

/// Choose up to `size` things so that all strata are served alike: one after the other of each stratum as
/// long as it has any, and evenly spread within it. Returns ascending indices; deterministic.
std::vector<std::size_t> stratified_sample(std::span<const int> strata, std::size_t size);

}  // namespace fretwork::reduction
