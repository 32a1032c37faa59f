// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

namespace fretwork::reduction {

/// What a linear model does at the setting's magnitudes, in the form of a pattern's responses: a target that
/// this very model meets exactly.
std::vector<Response> linear_responses(const UnitDisplacements& model, const Setting& setting);

}  // namespace fretwork::reduction
