// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/nlopt_options.hpp>

#include <memory>

namespace fretwork::optimization {

/// BOBYQA of NLopt [Powell2009]: descents by values, on quadratic models, from low-discrepancy points.
std::unique_ptr<Optimizer> make_bobyqa(const NloptOptions& options);

}  // namespace fretwork::optimization
