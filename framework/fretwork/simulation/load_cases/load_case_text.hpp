// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>
#include <vector>

namespace fretwork::simulation {

/// The entries of a load case for people, one line each, with effect and number of nodes:
/// "support  left: 9 nodes  ux uy uz". Throws InputError as check_selections.
std::vector<std::string> entry_texts(const LoadCase& load_case, const tiling::Tessellation& tessellation);

/// Warnings about values that look like errors of units, one line each: points away from the surface,
/// displacements larger than the surface, rotations of more than a turn, loads of more than three hundred
/// times its weight, and gravity of more than ten times the earth's.
std::vector<std::string> doubts_about(const LoadCase& load_case, const Surface& surface);

}  // namespace fretwork::simulation
