// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>
#include <vector>

namespace fretwork::simulation {

/// Describe the entries of a load case, one line each, with the number of nodes and the effect, such as
/// "support    left: 9 nodes  holds ux uy uz". Throws InputError as check_selections().
std::vector<std::string> entry_texts(const LoadCase& load_case, const tiling::Tessellation& tessellation);

/// Warnings, one line each, about values that look like errors of units: points away from the surface,
/// displacements larger than the surface, rotations of more than a turn, loads of more than three hundred
/// times the surface's weight (if it is known), and gravity of more than ten times the earth's gravity.
/// Throws InputError as resolve().
std::vector<std::string> warnings_about(const LoadCase& load_case, const Surface& surface);

}  // namespace fretwork::simulation
