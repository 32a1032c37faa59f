// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/simulation/surface.hpp>

#include <span>
#include <string>

namespace fretwork::simulation {

/// The choice of a tile model for each tile of a surface.
struct ModelChoice {
    std::string name = "full";  ///< name of the model of all tiles without their own tile model
    std::span<const reduction::TileModel> models = reduction::tile_models();  ///< catalogue of tile models
};

/// The tile model of one tile. Throws InputError if the name is unknown.
const reduction::TileModel& tile_model(const Surface& surface, const ModelChoice& choice,
                                       tiling::TileIndex tile);

/// Large if any tile of the surface has a model for large displacements, Small otherwise. Throws as
/// tile_model().
reduction::Displacements displacements(const Surface& surface, const ModelChoice& choice);

/// The calibrated parameters of a tile's pattern for a tile model, in the order of the model's row; empty for
/// a model without parameters. Throws InputError that names a tile without a pattern, or a pattern without a
/// calibration.
std::vector<double> tile_parameters(const Surface& surface, tiling::TileIndex tile,
                                    const reduction::TileModel& model);

/// A warning, in one line, if the mean side of the tiles with a calibrated model is more than 1.5 times the
/// tile side of the setting, or less than two thirds of it. Otherwise "". Throws as tile_model().
std::string foreign_size_text(const Surface& surface, const ModelChoice& choice);

}  // namespace fretwork::simulation
