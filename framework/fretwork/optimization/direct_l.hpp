// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/nlopt_options.hpp>

#include <memory>

namespace fretwork::optimization {

/// DIRECT-L of NLopt: divides the box, biased to local search [Gablonsky2001]. It ends by `patience`.
std::unique_ptr<Optimizer> make_direct_l(const NloptOptions& options);

}  // namespace fretwork::optimization
