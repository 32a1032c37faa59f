// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

namespace fretwork::reduction {

/// The responses of a linear model at the setting's magnitudes. A calibration to them can reach zero error,
/// because the model itself fits them exactly.
std::vector<Response> linear_responses(const UnitDisplacements& model, const Setting& setting);

}  // namespace fretwork::reduction
