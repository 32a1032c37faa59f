// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/bobyqa.hpp>
#include <fretwork/optimization/detail/nlopt_optimizer.hpp>

namespace fretwork::optimization {

std::unique_ptr<Optimizer> make_bobyqa(const NloptOptions& options) {
    return detail::make_nlopt_runs(NLOPT_LN_BOBYQA, options);
}

}  // namespace fretwork::optimization
