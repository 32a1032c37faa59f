// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.hpp"
#include "surface_result.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>

namespace fretwork::app {

simulation::SurfaceResult read_surface_result(const std::string& file) {
    simulation::SurfaceResult result = simulation::read_surface_result(file);
    simulation::check_subject(*result.subject, file);
    for (const std::string& warning : simulation::result_warnings(result)) warn(file + ": " + warning);
    return result;
}

void check_subject_of(const simulation::SurfaceIdentity& surface, const simulation::SurfaceResult& result,
                      const std::string& file) {
    const std::string difference = simulation::subject_difference(*result.subject, surface);
    if (!difference.empty())
        throw base::InputError(file, "", "is not a result of this project: they differ in " + difference);
}

}  // namespace fretwork::app
