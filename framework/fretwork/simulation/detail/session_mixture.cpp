// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/detail/session_mixture.hpp>
#include <fretwork/simulation/mixed_model.hpp>

#include <algorithm>
#include <map>

namespace fretwork::simulation {

using tiling::TileIndex;

Session::Mixture::Mixture(const Impl& plain, const SimulationOptions& options)
    : options_(options),
      share_(mixed_share(options.model).value()),
      impl_(plain.surface(), plain.load_case(), plain.options(), [&plain](const std::string& id) {
          // The same surface was painted first. A source that is asked twice may fail the second time.
          const Surface& painted = plain.surface();
          const auto& palette = painted.tessellation.patterns;
          const auto entry = std::ranges::find(palette, id, &pattern::NamedPattern::id);
          return painted.calibrations.at(entry - palette.begin());
      }) {}

/// Tiles with their own model keep it.
void Session::Mixture::choose(const Impl& plain, const base::Control& control) {
    const std::vector<TileDeformation> deformations =
        plain.tile_deformations(corotational_.solution, control);
    full_tiles_ = worst_tiles(plain.surface(), deformations, share_);
    std::vector<std::string> wanted = plain.surface().tile_models;
    wanted.resize(deformations.size());
    for (const TileIndex tile : full_tiles_) wanted[tile] = reference_choice(options_).name;
    std::vector<std::string> present = impl_.surface().tile_models;
    present.resize(deformations.size());
    std::map<std::string, std::vector<TileIndex>> changed;
    for (std::size_t t = 0; t < wanted.size(); ++t) {
        if (wanted[t] != present[t]) changed[wanted[t]].emplace_back(t);
    }
    for (const auto& [model, tiles] : changed) impl_.set_tile_model(tiles, model);
}

SurfaceResult Session::Mixture::solve(Impl& plain, const base::Control& control,
                                      mechanics::StabilityCheck check) {
    full_tiles_.clear();
    corotational_ = plain.solve(control, check);
    report_ = plain.last_report();
    if (!corotational_.solution.converged()) return corotational_;
    choose(plain, control);
    if (full_tiles_.empty()) return corotational_;
    SurfaceResult mixed = impl_.solve(control, check);
    mixed.seconds += corotational_.seconds;
    report_.tiles_built += impl_.last_report().tiles_built;
    if (impl_.last_report().starting_point == mechanics::StartingPoint::Rest)
        report_.starting_point = mechanics::StartingPoint::Rest;
    return mixed;
}

}  // namespace fretwork::simulation
