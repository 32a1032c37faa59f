// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_case.hpp>
#include <fretwork/simulation/surface.hpp>

#include <vector>

namespace fretwork::simulation {

/// A load case on a surface: which interface nodes are held, and what acts on each. The same for every model.
struct Conditions {
    std::vector<mechanics::Support> supports;
    std::vector<mechanics::PrescribedDisplacement> prescribed;
    std::vector<mechanics::NodalLoad> loads;  ///< of the load case, then the shares of the tiles' weight
};

/// Throws InputError that names the entry of the load case which picks no node, or gravity where beams have
/// no density.
Conditions resolve(const LoadCase& load_case, const Surface& surface);

}  // namespace fretwork::simulation
