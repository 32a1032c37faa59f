// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/nlopt_options.hpp>

#include <memory>

namespace fretwork::optimization {

/// Multi-level single linkage of NLopt: Sobol points, of which those far from better ones begin descents by
/// SLSQP [RinnooyKan1987, Kucherenko2005]. It ends by `patience`: the time of its clustering grows with the
/// square of the number of points.
std::unique_ptr<Optimizer> make_mlsl(const NloptOptions& options);

}  // namespace fretwork::optimization
