// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/detail/nlopt_optimizer.hpp>
#include <fretwork/optimization/direct_l.hpp>

namespace fretwork::optimization {

std::unique_ptr<Optimizer> make_direct_l(const NloptOptions& options) {
    return detail::make_nlopt_search(NLOPT_GN_DIRECT_L, std::nullopt, options);
}

}  // namespace fretwork::optimization
