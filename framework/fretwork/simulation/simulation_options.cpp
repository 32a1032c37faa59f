// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/simulation_options.hpp>

namespace fretwork::simulation {

bool is_nonlinear(const Surface& surface, const SimulationOptions& options) {
    const ModelChoice choice{options.model, options.models};
    return displacements(surface, choice) == reduction::Displacements::Large &&
           options.analysis == Analysis::OfTheModel;
}

void SimulationOptions::validate(const Surface& surface) const {
    const bool nonlinear = is_nonlinear(surface, *this);
    if (threads < 0)
        throw base::InputError("threads: " + std::to_string(threads) + " must not be negative");
    if (estimate_error && !nonlinear)
        throw base::InputError(
            "the discretization error is estimated for nonlinear models made of beams only");
    if (load_steps > 1 && !nonlinear)
        throw base::InputError("load_steps is " + std::to_string(load_steps) +
                               ", where a linear solution has no path to divide");
    constexpr int kMostSteps = 10000;
    if (load_steps < 1 || load_steps > kMostSteps) {
        throw base::InputError("load_steps is " + std::to_string(load_steps) + ", where 1 to " +
                               std::to_string(kMostSteps) + " are possible");
    }
}

}  // namespace fretwork::simulation
