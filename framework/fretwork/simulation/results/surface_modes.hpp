// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/modes.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/surface.hpp>

#include <vector>

namespace fretwork::simulation {

/// The kind of modes.
enum class ModeKind {
    Vibration,  ///< modes of natural frequencies
    Buckling    ///< modes of critical load factors
};

/// The lowest modes of a surface with all of its beams, under the supports and (for buckling) the loads of a
/// load case. A mode has one row for each node of surface_beams(). Throws as mechanics::vibration_modes() or
/// mechanics::buckling_modes(), and InputError as resolve() and surface_frame().
std::vector<mechanics::Mode> surface_modes(const Surface& surface, const LoadCase& load_case, ModeKind kind,
                                           int count, const mechanics::ModeOptions& options = {});

}  // namespace fretwork::simulation
