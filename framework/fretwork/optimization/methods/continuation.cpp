// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/optimization/methods/continuation.hpp>

#include <algorithm>

namespace fretwork::optimization {

void ContinuationOptions::validate() const {
    const bool descends =
        !smoothing.empty() && std::ranges::is_sorted(smoothing, std::greater<>()) && smoothing.back() >= 0.0;
    if (!descends) throw base::InputError("smoothing: at least one stage, descending, none negative");
    if (!(loose_tolerance > 0.0 && tolerance > 0.0)) {
        throw base::InputError("tolerance: must be more than 0");
    }
    if (largest_iterations < 1 || samples_per_start < 1) {
        throw base::InputError("iterations and samples: at least 1");
    }
}

}  // namespace fretwork::optimization
