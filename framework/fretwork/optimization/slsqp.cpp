// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/detail/nlopt_optimizer.hpp>
#include <fretwork/optimization/slsqp.hpp>

namespace fretwork::optimization {

std::unique_ptr<Optimizer> make_slsqp(const NloptOptions& options) {
    return detail::make_nlopt_runs(NLOPT_LD_SLSQP, options);
}

}  // namespace fretwork::optimization
