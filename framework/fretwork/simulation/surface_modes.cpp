// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/surface_frame.hpp>
#include <fretwork/simulation/surface_modes.hpp>

#include <algorithm>

namespace fretwork::simulation {
namespace {

/// Every beam of every tile.
mechanics::Assembly full_assembly(Surface surface, const LoadCase& load_case, const base::Control& control) {
    surface.tile_models.clear();
    const auto& models = reduction::tile_models();
    const auto full = std::ranges::find(models, reduction::Role::Reference, &reduction::TileModel::role);
    const Conditions conditions = resolve(load_case, surface);
    return mechanics::assemble(surface_frame(surface, {full->name, models}, conditions, control),
                               {.control = control});
}

}  // namespace

std::vector<mechanics::Mode> surface_modes(const Surface& surface, const LoadCase& load_case, ModeKind kind,
                                           int count, const mechanics::ModeOptions& options) {
    const mechanics::Assembly assembly = full_assembly(surface, load_case, options.control);
    return kind == ModeKind::Vibration ? mechanics::vibration_modes(assembly, count, options)
                                       : mechanics::buckling_modes(assembly, count, options);
}

}  // namespace fretwork::simulation
