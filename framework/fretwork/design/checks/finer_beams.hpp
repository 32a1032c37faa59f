// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/paths/branch.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/surface.hpp>

#include <optional>

namespace fretwork::design::detail {

struct FinerBeams {
    int elements = 2;  ///< number of elements of each beam
    mechanics::Branch branch = mechanics::Branch::Primary;
    int threads = 0;
};

/// The largest von Mises stress (Pa) at the ends of all elements in the nonlinear equilibrium of a surface
/// under a load case, with FinerBeams::elements for each beam. The difference from one element for each beam
/// shows the discretization error. None if no stable equilibrium was found. Throws Stopped.
std::optional<double> largest_stress(const simulation::Surface& surface,
                                     const simulation::LoadCase& load_case, const FinerBeams& options,
                                     const base::Control& control);

}  // namespace fretwork::design::detail
