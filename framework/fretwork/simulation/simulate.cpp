// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/result_subject.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>

namespace fretwork::simulation {

mechanics::Result simulate(const Surface& surface, const LoadCase& load_case,
                           const SimulationOptions& options, const base::Control& control) {
    mechanics::Result result = Session(surface, load_case, options).solve(control);
    result.subject = result_subject(surface, load_case, options);
    return result;
}

}  // namespace fretwork::simulation
