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

/// A painted tessellation with the setting and calibrations from which its tiles are built.
struct Surface {
    pattern::NodeLayout layout;         ///< node layout of all patterns
    tiling::Tessellation tessellation;  ///< painted tiles
    reduction::Setting setting;         ///< setting, with material and section of the beams
    /// For each of Tessellation::patterns, its best calibration for each tile model with calibrations in the
    /// library.
    std::vector<std::vector<reduction::Calibration>> calibrations;
    /// The name of each tile's own tile model; "" for a tile with the simulation's model. If the vector is
    /// empty, all tiles have the simulation's model.
    base::IndexVector<tiling::TileIndex, std::string> tile_models{};
};

/// Make the surface of a project, with the setting from setting_of(). If `library` is null, there are no
/// calibrations. Throws InputError if the library has another layout or setting, or lacks a pattern of the
/// project; and as models_by_tile().
Surface make_surface(const Project& project, const library::Library* library);

/// All beams of all tiles as one graph. Throws InputError that names an unpainted tile.
tiling::TessellationFan surface_fan(const Surface& surface);

/// The mass of each tile's beams, kg. Throws as surface_fan().
base::IndexVector<tiling::TileIndex, double> tile_masses(const Surface& surface);

}  // namespace fretwork::simulation
