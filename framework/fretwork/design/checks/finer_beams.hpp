// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/paths/branch.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/surface.hpp>

#include <optional>

namespace fretwork::design::detail {

/// Options of largest_stress().
struct FinerBeams {
    int elements = 2;  ///< number of elements of each beam
    mechanics::Branch branch = mechanics::Branch::Primary;
    int threads = 0;
};

/// Solve a surface under a load case with the full model, nonlinearly, and with FinerBeams::elements elements
/// for each beam. The result is the largest von Mises stress (Pa) at the ends of the elements. Its difference
/// from the result with one element for each beam shows the discretization error. None if no stable
/// equilibrium was found. Throws Stopped.
std::optional<double> largest_stress(const simulation::Surface& surface,
                                     const simulation::LoadCase& load_case, const FinerBeams& options,
                                     const base::Control& control);

}  // namespace fretwork::design::detail
