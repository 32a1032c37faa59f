// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/results/result_file.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

namespace fretwork::simulation {

/// Which equilibria a surface follows where its path becomes unstable.
enum class StablePath {
    Branches,  ///< after a push along the critical mode, the stable branch (mechanics::Branch::Stable)
    Snaps      ///< the same, and beyond limit loads (mechanics::follow_snapping_path)
};

/// Simulate a surface along a path that a specimen can follow; Solution::stability_losses tells where it was
/// left. As simulate(), for models of large displacements other than mixed ones, and without estimates of
/// errors. Throws InputError for others.
mechanics::Result simulate_stable_path(const Surface& surface, const LoadCase& load_case,
                                       const SimulationOptions& options, StablePath path,
                                       const base::Control& control = {});

}  // namespace fretwork::simulation
