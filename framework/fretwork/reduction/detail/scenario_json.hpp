// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>

namespace fretwork::reduction::detail {

/// Read a scenario, from its own document or from a setting. Throws InputError with the place.
Scenario read_scenario(const base::JsonReader& json);
base::Json scenario_json(const Scenario& scenario);

}  // namespace fretwork::reduction::detail
