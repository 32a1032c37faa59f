// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

namespace fretwork::simulation {

/// Simulate a surface under a load case by a new session, and compute the modes and estimates that the
/// options ask for. Interface nodes come first in the result, with the same ids in every model. The result
/// has a subject. Paper, Section 6. Throws InputError (options, load case, calibrations), NumericalError (too
/// few supports, or displacements that no result has), base::Stopped.
SurfaceResult simulate(const Surface& surface, const LoadCase& load_case,
                       const SimulationOptions& options = {}, const base::Control& control = {});

}  // namespace fretwork::simulation
