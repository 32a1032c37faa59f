// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/pagmo_options.hpp>

namespace fretwork::optimization {

void PagmoOptions::validate() const {
    common.validate();
    if (!(tolerance >= 0.0)) {
        throw base::InputError("tolerance: " + base::format_number(tolerance) + " must be at least 0");
    }
    if (largest_generations < 1) {
        throw base::InputError("generations: " + std::to_string(largest_generations) + " must be at least 1");
    }
}

}  // namespace fretwork::optimization
