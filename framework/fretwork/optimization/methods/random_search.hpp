// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>

namespace fretwork::optimization {

/// Random search: independent uniform points until the budget is spent. Random search is the baseline for
/// other methods. Only the seed is used. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_random_search(const OptimizerOptions& options);

}  // namespace fretwork::optimization
