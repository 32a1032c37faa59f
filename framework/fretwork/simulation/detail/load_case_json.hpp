// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>

namespace fretwork::simulation::detail {

/// A load case as it stands in its own file and in a project. Throws InputError with the JSON pointer.
LoadCase load_case_from_json(const base::JsonReader& json);
/// load_case_from_json gives an equal load case.
base::Json load_case_to_json(const LoadCase& load_case);

}  // namespace fretwork::simulation::detail
