// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/tiling/tessellation_fan.hpp>

#include <string_view>
#include <vector>

namespace fretwork::simulation {

/// A painted tessellation with its setting and calibrations: what its tiles are built from.
struct Surface {
    pattern::NodeLayout layout;
    tiling::Tessellation tessellation;
    reduction::Setting setting;  ///< material and section of the beams
    /// For each of Tessellation::patterns its best calibration of each tile model, as far as a library has
    /// them.
    std::vector<std::vector<reduction::Calibration>> calibrations;
    /// The tile model of each tile; "" for a tile that takes the simulation's model. If the vector is empty,
    /// all tiles take it.
    base::IndexVector<tiling::TileIndex, std::string> tile_models{};
};

/// Gather a project's surface. `library` may be null; then there are no calibrations. The setting is the
/// project's, else the library's, else the paper's. Throws InputError if the library is one of another layout
/// or setting.
Surface make_surface(const Project& project, const library::Library* library);

/// All beams of all tiles. Throws InputError that names a tile that is not painted.
tiling::TessellationFan surface_fan(const Surface& surface);

/// The mass of every tile's beams, kg: what gravity is applied to.
base::IndexVector<tiling::TileIndex, double> tile_masses(const Surface& surface);

}  // namespace fretwork::simulation
