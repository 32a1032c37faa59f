// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>
#include <fretwork/simulation/simulation_options.hpp>

#include <cstdio>

namespace fretwork::simulation {

std::string linear_range_text(const mechanics::LinearRange& range) {
    char text[200];
    if (range.loses_stability)
        return "the load is beyond the surface's buckling load: a linear solution knows nothing of where it "
               "goes";
    std::snprintf(text, sizeof text,
                  "displacements are %s for a linear solution: they are off by about %.0f %% of the largest",
                  is_exceeded(range) ? "too large" : "small enough", 100.0 * range.error);
    return text;
}

mechanics::LinearRange surface_linear_range(const Surface& surface, const LoadCase& load_case, int threads,
                                            const base::Control& control) {
    Surface plain = surface;
    plain.tile_models.clear();
    const ModelChoice corotational{.name = kMixedTiles};
    const auto tiles =
        detail::TileBuilder().build_all(plain, corotational, {.threads = threads, .control = control});
    mechanics::Assembly assembly =
        reduction::assemble(detail::join_tiles(plain, tiles, control).parts, control);
    apply(resolve(load_case, plain), assembly);
    return mechanics::linear_range(assembly, {.threads = threads, .control = control});
}

}  // namespace fretwork::simulation
