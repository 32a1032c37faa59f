// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>
#include <fretwork/simulation/simulation_options.hpp>

#include <algorithm>
#include <cstdio>

namespace fretwork::simulation {
namespace {

mechanics::LinearPath surface_linear_path(const Surface& surface, const LoadCase& load_case, int threads,
                                          const base::Control& control) {
    Surface plain = surface;
    plain.tile_models.clear();
    const ModelChoice corotational{.name = kMixedTiles};
    const auto tiles =
        detail::TileBuilder().build_all(plain, corotational, {.threads = threads, .control = control});
    mechanics::Assembly assembly =
        reduction::assemble(detail::join_tiles(plain, tiles, control).parts, control);
    apply(resolve(load_case, plain), assembly);
    return mechanics::linear_path(assembly, {.threads = threads, .control = control});
}

bool has_fitted_tiles(const Surface& surface, const SimulationOptions& options) {
    const ModelChoice choice = model_choice(options);
    for (std::size_t t = 0; t < surface.tessellation.tiles.size(); ++t) {
        if (!tile_model(surface, choice, tiling::TileIndex(t)).parameters.empty()) return true;
    }
    return false;
}

/// The largest distance of the interface nodes from those of another linear solution, as a share of the
/// largest displacement there.
double largest_difference(const Surface& surface, const mechanics::NodeValues& fitted,
                          const mechanics::NodeValues& own) {
    const auto count = std::ssize(surface.tessellation.interface_nodes);
    const auto translations = [&](const mechanics::NodeValues& rows) {
        return rows.topRows(count).leftCols<3>();
    };
    const double largest = translations(own).rowwise().norm().maxCoeff();
    if (largest == 0.0) return 0.0;
    return (translations(fitted) - translations(own)).rowwise().norm().maxCoeff() / largest;
}

}  // namespace

std::string linear_range_text(const mechanics::LinearRange& range) {
    char text[200];
    if (range.loses_stability)
        return "the load is beyond the surface's buckling load: a linear solution does not show how it "
               "deforms then";
    std::snprintf(text, sizeof text,
                  "displacements are %s for a linear solution: they are off by about %.0f %% of the largest",
                  is_exceeded(range) ? "too large" : "small enough", 100.0 * range.error);
    return text;
}

bool is_out_of_range(const SurfaceResult& result) {
    if (!result.linear_range) return false;
    return is_exceeded(*result.linear_range) ||
           result.linear_range->error + result.fit_error.value_or(0.0) > kLinearRange;
}

std::string linear_doubt_text(const SurfaceResult& result) {
    const mechanics::LinearRange& range = result.linear_range.value();
    if (!result.fit_error) return linear_range_text(range);
    const double fit = 100.0 * *result.fit_error;
    char text[160];
    if (!range.loses_stability && !is_exceeded(range)) {
        std::snprintf(
            text, sizeof text,
            "the linear solution is off by about %.0f %% of the largest displacement, and the fitted "
            "tiles by about %.2g %% more",
            100.0 * range.error, fit);
        return text;
    }
    std::snprintf(text, sizeof text, "; the fitted tiles are off by about %.2g %% more", fit);
    return linear_range_text(range) + text;
}

mechanics::LinearRange surface_linear_range(const Surface& surface, const LoadCase& load_case, int threads,
                                            const base::Control& control) {
    return surface_linear_path(surface, load_case, threads, control).range;
}

void add_linear_range(const Surface& surface, const LoadCase& load_case, const SimulationOptions& options,
                      const base::Control& control, SurfaceResult& result) {
    const mechanics::LinearPath path = surface_linear_path(surface, load_case, options.threads, control);
    result.linear_range = path.range;
    if (has_fitted_tiles(surface, options))
        result.fit_error = largest_difference(surface, result.solution.displacements, path.displacements);
}

}  // namespace fretwork::simulation
