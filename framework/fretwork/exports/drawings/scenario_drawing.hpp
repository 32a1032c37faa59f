// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/reduced_drawing.hpp>

#include <span>

namespace fretwork::exports {

/// The setting's scenarios on one tile, side by side as in the paper's Fig. 10, in parallel projection at
/// true scale: the tile at rest with its supports and loads (signs as in surface_svg), the pattern's full
/// model under the largest magnitude (grey) and the reduced model, if there is one (blue). Where the full
/// model finds no equilibrium at the largest magnitude, the last one before is drawn, and the caption says at
/// which.
std::string scenario_sheet_svg(const pattern::NodeLayout& layout, const ReducedPattern& pattern,
                               const reduction::Setting& setting,
                               std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports
