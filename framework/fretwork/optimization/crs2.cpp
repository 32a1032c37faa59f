// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/crs2.hpp>
#include <fretwork/optimization/detail/nlopt_optimizer.hpp>

namespace fretwork::optimization {

std::unique_ptr<Optimizer> make_crs2(const NloptOptions& options) {
    return detail::make_nlopt_runs(NLOPT_GN_CRS2_LM, options);
}

}  // namespace fretwork::optimization
