// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/simulation/surface.hpp>

#include <span>
#include <string>

namespace fretwork::simulation {

/// Which tile model each tile of a surface has.
struct ModelChoice {
    std::string name = "full";  ///< of the tiles for which the surface names none
    std::span<const reduction::TileModel> models = reduction::tile_models();
};

/// The tile model of one tile. Throws InputError if the name is unknown.
const reduction::TileModel& tile_model(const Surface& surface, const ModelChoice& choice,
                                       tiling::TileIndex tile);

/// Whether any tile of the surface has a model that is made for large displacements.
reduction::Displacements displacements(const Surface& surface, const ModelChoice& choice);

/// The calibrated parameters of a tile's pattern for a tile model, in the order of its row; none for a model
/// to which nothing is fitted. Throws InputError that names a tile without a pattern, or a pattern without a
/// calibration.
std::vector<double> tile_parameters(const Surface& surface, tiling::TileIndex tile,
                                    const reduction::TileModel& model);

/// One line where tiles are half as large again as those for which their models are calibrated, or smaller
/// than two thirds of them; "" else.
std::string foreign_size_text(const Surface& surface, const ModelChoice& choice);

}  // namespace fretwork::simulation
