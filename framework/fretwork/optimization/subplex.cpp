// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/detail/nlopt_optimizer.hpp>
#include <fretwork/optimization/subplex.hpp>

namespace fretwork::optimization {

std::unique_ptr<Optimizer> make_subplex(const NloptOptions& options) {
    return detail::make_nlopt_runs(NLOPT_LN_SBPLX, options);
}

}  // namespace fretwork::optimization
