// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_result.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>

#include <cstdio>

namespace fretwork::app {

simulation::SurfaceResult read_surface_result(const std::string& file) {
    simulation::SurfaceResult result = simulation::read_surface_result(file);
    simulation::check_subject(*result.subject, file);
    const auto warn = [&](const std::string& warning) {
        if (!warning.empty())
            std::fprintf(stderr, "fretwork: %s: %s\n", base::printable(file).c_str(), warning.c_str());
    };
    if (simulation::is_out_of_range(result)) warn(simulation::linear_doubt_text(result));
    warn(simulation::model_warning(result));
    return result;
}

}  // namespace fretwork::app
