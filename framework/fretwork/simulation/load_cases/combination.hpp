// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/load_cases/load_case.hpp>

#include <span>

namespace fretwork::simulation {

/// The load case with this name. Throws InputError that suggests the nearest name, or lists all names.
const LoadCase& load_case_of(const std::string& name, std::span<const LoadCase> cases);

/// Merge a load case with the load cases that it combines. Their loads, area loads, prescribed displacements
/// and gravity are multiplied by their factors and added; their supports are added, too. The factors of a
/// load case that is named several times are added. A load case that combines no others is returned
/// unchanged. Messages about an entry name the load case from which it was taken. Throws InputError if a
/// combined load case is not among `cases`, is the load case itself, or is also a combination.
LoadCase combined(const LoadCase& load_case, std::span<const LoadCase> cases);

/// Check that a load case combines only others among `cases` that are no combinations. Throws InputError as
/// combined(), without the name of the load case: "/combines/0/load_case: ..".
void check_combination(const LoadCase& load_case, std::span<const LoadCase> cases);
/// Check that each load case combines only others that exist and are no combinations. Throws InputError as
/// combined().
void check_combinations(std::span<const LoadCase> cases);

}  // namespace fretwork::simulation
