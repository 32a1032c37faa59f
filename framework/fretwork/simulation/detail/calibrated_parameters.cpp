// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/detail/calibrated_parameters.hpp>

#include <algorithm>

namespace fretwork::simulation::detail {

std::vector<double> calibrated_parameters(std::span<const reduction::Calibration> calibrations,
                                          const std::string& pattern, const reduction::TileModel& model) {
    if (model.parameters.empty()) return {};
    const auto found = std::ranges::find(calibrations, model.name, &reduction::Calibration::model);
    if (found != calibrations.end()) return reduction::parameter_values(*found, model);
    throw base::InputError({.problem = "pattern " + pattern + " has no calibration of the tile model " +
                                       model.name +
                                       ": name a library that has it ('fretwork calibrate' makes one)",
                            .kind = base::ErrorKind::NotCalibrated,
                            .about = {pattern, model.name}});
}

}  // namespace fretwork::simulation::detail
