// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/nlopt_options.hpp>

#include <memory>

namespace fretwork::optimization {

/// Controlled random search with local mutation of NLopt [Kaelo2006].
std::unique_ptr<Optimizer> make_crs2(const NloptOptions& options);

}  // namespace fretwork::optimization
