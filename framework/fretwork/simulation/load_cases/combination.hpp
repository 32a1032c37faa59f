// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>

#include <span>

namespace fretwork::simulation {

/// The load case of a name. Throws InputError that names the nearest, or all.
const LoadCase& load_case_of(const std::string& name, std::span<const LoadCase> cases);

/// A load case with what it combines: loads, area loads, prescribed displacements and gravity of the other
/// cases times their factors, and the supports of all of them. One that combines nothing stays as it is.
/// Throws InputError if it names a case that is not among `cases`, itself, or one that is a combination, too.
LoadCase combined(const LoadCase& load_case, std::span<const LoadCase> cases);

}  // namespace fretwork::simulation
