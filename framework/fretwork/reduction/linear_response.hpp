// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

namespace fretwork::reduction {

/// The responses of a linear model at the setting's magnitudes. A calibration of the same model to these
/// responses can reach zero error.
std::vector<Response> linear_responses(const UnitDisplacements& model, const Setting& setting);

}  // namespace fretwork::reduction
