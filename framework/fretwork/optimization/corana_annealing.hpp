// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/pagmo_options.hpp>

#include <memory>

namespace fretwork::optimization {

/// Simulated annealing of pagmo with adaptive neighbourhoods [Corana1987]: temperature 10 down to 0.1 in ten
/// steps, with ten adjustments of the ranges at each.
std::unique_ptr<Optimizer> make_corana_annealing(const PagmoOptions& options);

}  // namespace fretwork::optimization
