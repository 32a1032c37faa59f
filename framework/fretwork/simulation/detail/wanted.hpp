// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

namespace fretwork::simulation::detail {

/// Add the modes and, for a linear solution, the linear range that the options ask for.
void add_wanted(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
                const base::Control& control, SurfaceResult& result);

}  // namespace fretwork::simulation::detail
