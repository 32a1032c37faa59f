// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/nlopt_options.hpp>

namespace fretwork::optimization {

void NloptOptions::validate() const {
    common.validate();
    if (!(tolerance > 0.0)) {
        throw base::InputError("tolerance: " + base::format_number(tolerance) + " must be more than 0");
    }
    if (!(initial_step > 0.0 && initial_step <= 1.0)) {
        throw base::InputError("initial step: " + base::format_number(initial_step) +
                               " must be a share of the box, more than 0 and at most 1");
    }
    if (patience < 1) {
        throw base::InputError("patience: " + std::to_string(patience) + " evaluations must be at least 1");
    }
}

}  // namespace fretwork::optimization
