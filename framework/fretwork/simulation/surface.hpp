// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/calibration.hpp>
#include <fretwork/reduction/setting.hpp>
#include <fretwork/simulation/project.hpp>
#include <fretwork/tiling/tessellation_fan.hpp>

#include <optional>
#include <vector>

namespace fretwork::simulation {

/// A painted tessellation with what its beams are made of: all that a model of it is built from.
struct Surface {
    pattern::NodeLayout layout;
    tiling::Tessellation tessellation;
    tiling::TessellationFan fan;             ///< all beams of all tiles
    std::vector<pattern::Pattern> patterns;  ///< those of Tessellation::patterns
    reduction::Setting setting;  ///< material and section; the paper's if the project has no library
    /// For each of the patterns its best calibration of the paper's reduced model, if the library has one.
    std::vector<std::optional<reduction::Calibration>> calibrations;
};

/// Gather a project's surface. `library` may be null; then the setting is the paper's, and there are no
/// calibrations. Throws InputError if the library is one of another layout.
Surface make_surface(const Project& project, const library::Library* library);

/// The weight of every tile's beams, in kilograms, and so what gravity is applied to.
std::vector<double> tile_masses(const Surface& surface);

}  // namespace fretwork::simulation
