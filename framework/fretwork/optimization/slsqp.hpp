// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/nlopt_options.hpp>

#include <memory>

namespace fretwork::optimization {

/// SLSQP of NLopt [Kraft1994]: descents by gradients, by sequential quadratic programming, from
/// low-discrepancy points.
std::unique_ptr<Optimizer> make_slsqp(const NloptOptions& options);

}  // namespace fretwork::optimization
