// SPDX-License-Identifier: GPL-3.0-or-later
// Load stages as JSON inside other documents.
#pragma once

#include <fretwork/base/json_reader.hpp>
#include <fretwork/simulation/stages.hpp>

#include <vector>

namespace fretwork::simulation {

/// Read load stages as they stand in their own file. Throws InputError with the JSON pointer.
std::vector<LoadStage> read_stages(const base::JsonReader& json);

}  // namespace fretwork::simulation
