// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_result.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>

#include <cstdio>

namespace fretwork::app {

simulation::SurfaceResult read_surface_result(const std::string& file) {
    simulation::SurfaceResult result = simulation::read_surface_result(file);
    simulation::check_subject(*result.subject, file);
    if (result.linear_range && simulation::is_exceeded(*result.linear_range))
        std::fprintf(stderr, "fretwork: %s: %s\n", base::printable(file).c_str(),
                     simulation::linear_range_text(*result.linear_range).c_str());
    return result;
}

}  // namespace fretwork::app
