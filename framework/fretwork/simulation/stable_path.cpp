// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/paths/snapping.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/stable_path.hpp>

#include <chrono>

namespace fretwork::simulation {
namespace {

mechanics::Assembly assembly_of(const Surface& surface, const LoadCase& load_case,
                                const SimulationOptions& options, const base::Control& control) {
    const auto tiles = detail::TileBuilder().build_all(surface, model_choice(options),
                                                       {.threads = options.threads, .control = control});
    mechanics::Assembly assembly =
        reduction::assemble(detail::join_tiles(surface, tiles, control).parts, control);
    apply(resolve(load_case, surface), assembly);
    return assembly;
}

}  // namespace

mechanics::Result simulate_stable_path(const Surface& surface, const LoadCase& load_case,
                                       const SimulationOptions& options, StablePath path,
                                       const base::Control& control) {
    options.validate(surface);
    if (!is_nonlinear(surface, options) || mixed_share(options.model))
        throw base::InputError("model " + options.model +
                               ": a stable path is followed by full and corotational tiles, not by linear "
                               "solutions, nor by mixed models");
    if (options.estimate_error || options.estimate_model_error)
        throw base::InputError("along a stable path no error is estimated");
    const auto started = std::chrono::steady_clock::now();
    const mechanics::Assembly assembly = assembly_of(surface, load_case, options, control);
    mechanics::EquilibriumOptions how{
        .branch = mechanics::Branch::Stable, .threads = options.threads, .control = control};
    const auto factors = mechanics::even_load_factors(options.load_steps);
    mechanics::Result result;
    result.load_steps = path == StablePath::Snaps ? mechanics::follow_snapping_path(assembly, factors, how)
                                                  : mechanics::follow_load_path(assembly, factors, how);
    result.solution = mechanics::end_of_path(result.load_steps);
    if (options.load_steps == 1) result.load_steps.clear();
    result.solver = "newton";
    const auto interface_count = static_cast<int>(surface.tessellation.interface_nodes.size());
    for (int i = 0; i < assembly.reported_nodes; ++i)
        result.nodes.push_back({i, assembly.nodes[static_cast<std::size_t>(i)], i < interface_count});
    result.subject = result_subject(surface, load_case, options);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return result;
}

}  // namespace fretwork::simulation
