// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/detail/calibrated_parameters.hpp>
#include <fretwork/simulation/model_choice.hpp>

#include <cmath>

namespace fretwork::simulation {

const reduction::TileModel& tile_model(const Surface& surface, const ModelChoice& choice,
                                       tiling::TileIndex tile) {
    const std::size_t index = tile;
    const bool has_own = index < surface.tile_models.size() && !surface.tile_models[index].empty();
    return reduction::find_tile_model(has_own ? surface.tile_models[index] : choice.name, choice.models);
}

reduction::Displacements displacements(const Surface& surface, const ModelChoice& choice) {
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        const auto& model = tile_model(surface, choice, tiling::TileIndex(t));
        if (model.displacements == reduction::Displacements::Large) return reduction::Displacements::Large;
        if (surface.tile_models.empty()) break;  // all tiles have the same model
    }
    return reduction::Displacements::Small;
}

std::vector<double> tile_parameters(const Surface& surface, tiling::TileIndex tile,
                                    const reduction::TileModel& model) {
    const pattern::NamedPattern& pattern = tiling::painted_pattern_of(surface.tessellation, tile);
    const std::size_t index = surface.tessellation.tiles[tile].pattern;
    return detail::calibrated_parameters(surface.calibrations[index], pattern.id, model);
}

std::string foreign_size_text(const Surface& surface, const ModelChoice& choice) {
    constexpr double kMost = 1.5;
    const reduction::TileModel* calibrated = nullptr;
    double sides = 0.0;
    int count = 0;
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        const auto& model = tile_model(surface, choice, tiling::TileIndex(t));
        if (model.parameters.empty()) continue;
        calibrated = &model;
        sides += geometry::mean_side(tiling::tile_polygon(surface.tessellation, tiling::TileIndex(t)));
        ++count;
    }
    if (count == 0) return "";
    const double own = sides / count, theirs = surface.setting.tile_side;
    if (own <= kMost * theirs && theirs <= kMost * own) return "";
    const auto millimetres = [](double metres) {
        return base::format_number(std::round(1e4 * metres) / 10.0) + " mm";
    };
    return calibrated->name + " is calibrated for tiles with sides of " + millimetres(theirs) +
           "; those of this surface have " + millimetres(own);
}

}  // namespace fretwork::simulation
