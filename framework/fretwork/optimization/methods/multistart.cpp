// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/optimization/methods/multistart.hpp>

namespace fretwork::optimization {

void MultistartOptions::validate() const {
    common.validate();
    continuation.validate();
    if (!(merging_distance >= 0.0)) throw base::InputError("merging_distance: must not be negative");
    if (!(pruning_ratio >= 1.0)) throw base::InputError("pruning_ratio: must be at least 1");
}

}  // namespace fretwork::optimization
