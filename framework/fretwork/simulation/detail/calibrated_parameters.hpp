// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/calibration/calibration.hpp>

#include <span>
#include <string>
#include <vector>

namespace fretwork::simulation::detail {

/// A pattern's parameters for a tile model, from its calibrations; none for a model without fitted
/// parameters. Throws InputError that names the pattern if there is no calibration.
std::vector<double> calibrated_parameters(std::span<const reduction::Calibration> calibrations,
                                          const std::string& pattern, const reduction::TileModel& model);

}  // namespace fretwork::simulation::detail
