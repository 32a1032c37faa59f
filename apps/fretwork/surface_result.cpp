// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_result.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>

#include <cstdio>

namespace fretwork::app {

mechanics::Result read_surface_result(const std::string& file) {
    mechanics::Result result = mechanics::read_result(file);
    if (result.subject) {
        simulation::check_subject(*result.subject, file);
    } else {
        std::fprintf(stderr, "fretwork: %s does not say what it is a result of (an older program made it)\n",
                     base::printable(file).c_str());
    }
    if (result.linear_range && simulation::is_exceeded(*result.linear_range))
        std::fprintf(stderr, "fretwork: %s: %s\n", base::printable(file).c_str(),
                     simulation::linear_range_text(*result.linear_range).c_str());
    return result;
}

}  // namespace fretwork::app
