// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/nlopt_options.hpp>

#include <memory>

namespace fretwork::optimization {

/// Subplex of NLopt [Rowan1990]: descents by values, by simplices in subspaces, from low-discrepancy points.
std::unique_ptr<Optimizer> make_subplex(const NloptOptions& options);

}  // namespace fretwork::optimization
