// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/results/surface_modes.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface_frame.hpp>

namespace fretwork::simulation {
namespace {

/// The assembly with every beam.
mechanics::Assembly full_assembly(Surface surface, const LoadCase& load_case, const base::Control& control) {
    surface.tile_models.clear();
    const Conditions conditions = resolve(load_case, surface);
    return mechanics::assemble(surface_frame(surface, reference_choice({}), conditions, control),
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
