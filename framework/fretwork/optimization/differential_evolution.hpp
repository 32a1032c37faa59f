// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/pagmo_options.hpp>

#include <memory>

namespace fretwork::optimization {

/// Differential evolution of pagmo, variant rand/1/exp, with ten individuals a variable [Storn1997].
std::unique_ptr<Optimizer> make_differential_evolution(const PagmoOptions& options);

}  // namespace fretwork::optimization
