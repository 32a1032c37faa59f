// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/detail/calibrated_parameters.hpp>
#include <fretwork/simulation/detail/session_impl.hpp>
#include <fretwork/tiling/painting/painting.hpp>

#include <algorithm>

namespace fretwork::simulation {
namespace {

using tiling::TileIndex;

void require_tiles(const Surface& surface, std::span<const TileIndex> tiles) {
    const auto count = std::ssize(surface.tessellation.tiles);
    for (const TileIndex tile : tiles) {
        if (tile.value >= 0 && tile.value < count) continue;
        throw base::InputError("there is no tile " + std::to_string(tile.value) + "; they run from 0 to " +
                               std::to_string(count - 1));
    }
}

/// The painted tiles must have the calibrations that their models need.
void require_calibrations(const Surface& surface, const ModelChoice& choice) {
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        const TileIndex tile(t);
        if (surface.tessellation.tiles[t].pattern >= 0)
            (void)tile_parameters(surface, tile, tile_model(surface, choice, tile));
    }
}

}  // namespace

Conditions Session::Impl::resolved(const LoadCase& load_case) {
    if (!needs_masses(load_case, surface_)) return resolve(load_case, surface_, {});
    if (!tile_masses_) tile_masses_ = tile_masses(surface_);
    return resolve(load_case, surface_, tile_masses_.value());
}

void Session::Impl::paint(std::span<const TileIndex> tiles, const std::string& wanted) {
    require_tiles(surface_, tiles);
    const std::vector<pattern::NamedPattern>& palette = surface_.tessellation.patterns;
    const auto pattern = pattern::parse_named_pattern(surface_.layout, wanted);
    const std::size_t entry = std::ranges::find(palette, pattern) - palette.begin();
    const bool is_new = entry == palette.size();
    // Patterns of the palette were checked when they came into it.
    if (is_new) (void)tiling::make_palette(surface_.layout, std::vector{pattern.id});
    const auto calibrations = !is_new               ? surface_.calibrations[entry]
                              : calibration_source_ ? calibration_source_(pattern.id)
                                                    : std::vector<reduction::Calibration>{};
    for (const TileIndex tile : tiles)
        (void)detail::calibrated_parameters(calibrations, pattern.id, tile_model(surface_, choice(), tile));
    if (is_new) {
        surface_.tessellation.patterns.push_back(pattern);
        surface_.calibrations.push_back(calibrations);
    }
    for (const TileIndex tile : tiles) surface_.tessellation.tiles[tile].pattern = static_cast<int>(entry);
    invalidate_tiles(tiles);
    update_masses();
}

void Session::Impl::turn(std::span<const TileIndex> tiles, int vertices) {
    require_tiles(surface_, tiles);
    for (const TileIndex tile : tiles) tiling::turn(surface_.tessellation.tiles[tile], vertices);
    invalidate_tiles(tiles);
    update_masses();
}

void Session::Impl::set_tile_model(std::span<const TileIndex> tiles, const std::string& name) {
    require_tiles(surface_, tiles);
    const reduction::TileModel& model =
        reduction::find_tile_model(name.empty() ? options_.model : name, options_.models);
    for (const TileIndex tile : tiles) (void)tile_parameters(surface_, tile, model);
    std::vector<std::string> before = surface_.tile_models;
    surface_.tile_models.resize(surface_.tessellation.tiles.size());
    for (const TileIndex tile : tiles) surface_.tile_models[tile] = name;
    try {
        options_.validate(surface_);  // refuses load steps, say, if all tiles are linear
    } catch (const base::Error&) {
        surface_.tile_models = std::move(before);
        throw;
    }
    invalidate_tiles(tiles);
}

void Session::Impl::set_model(const std::string& name) {
    SimulationOptions edited = options_;
    edited.model = name;
    edited.validate(surface_);
    require_calibrations(surface_, {name, options_.models});
    options_.model = name;
    invalidate_all_tiles();
}

void Session::Impl::set_setting(const reduction::Setting& setting) {
    setting.validate();
    reduction::Setting before = std::exchange(surface_.setting, setting);
    try {
        (void)resolve(load_case_, surface_, {});
    } catch (const base::Error&) {
        surface_.setting = std::move(before);
        throw;
    }
    builder_.forget();
    invalidate_all_tiles();
    update_masses();
}

void Session::Impl::set_calibrations(std::vector<std::vector<reduction::Calibration>> calibrations) {
    if (calibrations.size() != surface_.tessellation.patterns.size())
        throw base::InputError("there are calibrations of " + std::to_string(calibrations.size()) +
                               " patterns, where the surface has " +
                               std::to_string(surface_.tessellation.patterns.size()));
    std::swap(surface_.calibrations, calibrations);
    try {
        require_calibrations(surface_, choice());
    } catch (const base::Error&) {
        std::swap(surface_.calibrations, calibrations);
        throw;
    }
    builder_.forget();
    invalidate_all_tiles();
}

void Session::Impl::set_load_case(const LoadCase& load_case) {
    conditions_ = resolved(load_case);
    load_case_ = load_case;
    is_at_equilibrium_ = false;
}

void Session::Impl::invalidate_tiles(std::span<const TileIndex> tiles) {
    changed_tiles_.insert(tiles.begin(), tiles.end());
    forget_solution();
}

void Session::Impl::invalidate_all_tiles() {
    tiles_.clear();
    changed_tiles_.clear();
    forget_solution();
}

void Session::Impl::update_masses() {
    tile_masses_.reset();
    if (!load_case_.gravity.isZero(0)) conditions_ = resolved(load_case_);
}

}  // namespace fretwork::simulation
