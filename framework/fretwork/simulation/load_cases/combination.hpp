// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>

#include <span>

namespace fretwork::simulation {

/// The load case with this name. Throws InputError that suggests the nearest name, or lists all.
const LoadCase& load_case_of(const std::string& name, std::span<const LoadCase> cases);

/// A load case merged with the load cases that it combines: their loads, area loads, prescribed displacements
/// and gravity times their factors, and all their supports. A load case that combines nothing is returned
/// unchanged. Throws InputError if it combines a load case that is not among `cases`, that is itself, or that
/// is also a combination.
LoadCase combined(const LoadCase& load_case, std::span<const LoadCase> cases);

}  // namespace fretwork::simulation
