// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/solve.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>

#include <algorithm>
#include <cstdio>

namespace fretwork::simulation {
namespace {

/// True if small differences may have decided where a path leads.
bool has_critical_places(const mechanics::Solution& end) {
    return end.iterations > kDoubtfulIterations || !end.stability_losses.empty();
}

}  // namespace

ModelDoubt model_doubt(std::span<const TileDeformation> tiles) {
    ModelDoubt doubt;
    for (const TileDeformation& tile : tiles)
        doubt.tile_rotation = std::max(doubt.tile_rotation, tile.rotation);
    return doubt;
}

ModelDoubt model_doubt(const Session& session, const SurfaceResult& result, const base::Control& control) {
    ModelDoubt doubt = model_doubt(session.tile_deformations(result.solution, control));
    const SurfaceResult* corotational = session.corotational_result();
    const bool is_changed = corotational != nullptr && !session.full_tiles().empty();
    if (!is_changed || !result.solution.converged()) return doubt;
    const Comparison comparison = compare(result, *corotational);
    if (comparison.max_displacement > 0.0)
        doubt.change = comparison.max_translation_error / comparison.max_displacement;
    return doubt;
}

bool is_doubtful(const SurfaceResult& result) {
    if (!result.model_doubt) return false;
    return result.model_doubt->tile_rotation > kDoubtfulRotation ||
           result.model_doubt->change > kDoubtfulChange || has_critical_places(result.solution) ||
           std::ranges::any_of(result.load_steps, has_critical_places);
}

double warned_error(const ModelError& error) {
    return error.full_share < 1.0 ? kWarnedEstimate : kWarnedError;
}

std::string path_warning(const SurfaceResult& result) {
    const mechanics::Solution& solution = result.solution;
    if (solution.converged())
        return solution.is_unstable() ? "this equilibrium is unstable: a specimen does not stay there" : "";
    if (result.solver != mechanics::solver_name(mechanics::Solver::Newton))
        return "this is not an equilibrium";
    char share[40];
    std::snprintf(share, sizeof share, "%.4g %% of the load", 100.0 * solution.load_factor);
    const bool has_stages = result.subject && !result.subject->stages_text.empty();
    const std::string path =
        has_stages ? "load stage " + std::to_string(result.load_steps.size()) : std::string("the path");
    return "this is not the answer to the load: " + path + " ends at " + share;
}

std::string model_warning(const SurfaceResult& result) {
    if (!result.solution.converged()) return "";
    const auto& error = result.model_error;
    if (!error)
        return is_doubtful(result) ? "this model may be off by more than 5 %; nothing was estimated" : "";
    if (error->largest <= warned_error(*error)) return "";
    char text[160];
    std::snprintf(text, sizeof text,
                  "this model is off by about %.2g %% of the largest displacement at the worst node, %.2g %% "
                  "on average",
                  100.0 * error->largest, 100.0 * error->mean);
    if (!error->largest_stress) return text;
    char stress[60];
    std::snprintf(stress, sizeof stress, ", and by %.2g %% of the largest stress",
                  100.0 * *error->largest_stress);
    return std::string(text) + stress;
}

std::vector<std::string> result_warnings(const SurfaceResult& result) {
    std::vector<std::string> warnings = {path_warning(result),
                                         is_out_of_range(result) ? linear_doubt_text(result) : "",
                                         model_warning(result)};
    std::erase(warnings, "");
    return warnings;
}

}  // namespace fretwork::simulation
