// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/pagmo_options.hpp>

#include <memory>

namespace fretwork::optimization {

/// CMA-ES of pagmo with bounds [Hansen2006], initial step 0.3 of the box; every restart doubles the
/// population, which begins with 4 + 3 ln n rounded down [Auger2005].
std::unique_ptr<Optimizer> make_cma_es(const PagmoOptions& options);

}  // namespace fretwork::optimization
