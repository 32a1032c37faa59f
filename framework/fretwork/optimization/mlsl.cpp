// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/detail/nlopt_optimizer.hpp>
#include <fretwork/optimization/mlsl.hpp>

namespace fretwork::optimization {

std::unique_ptr<Optimizer> make_mlsl(const NloptOptions& options) {
    return detail::make_nlopt_search(NLOPT_G_MLSL_LDS, NLOPT_LD_SLSQP, options);
}

}  // namespace fretwork::optimization
