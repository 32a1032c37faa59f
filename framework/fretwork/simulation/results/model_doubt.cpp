// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>

#include <algorithm>
#include <cstdio>

namespace fretwork::simulation {

ModelDoubt model_doubt(std::span<const TileDeformation> tiles) {
    ModelDoubt doubt;
    for (const TileDeformation& tile : tiles)
        doubt.tile_rotation = std::max(doubt.tile_rotation, tile.rotation);
    return doubt;
}

ModelDoubt model_doubt(const Session& session, const SurfaceResult& result) {
    ModelDoubt doubt = model_doubt(session.tile_deformations(result.solution));
    const SurfaceResult* corotational = session.corotational_result();
    if (corotational == nullptr || session.full_tiles().empty()) return doubt;
    const Comparison comparison = compare(result, *corotational);
    if (comparison.max_displacement > 0.0)
        doubt.change = comparison.max_translation_error / comparison.max_displacement;
    return doubt;
}

bool is_doubtful(const SurfaceResult& result) {
    if (!result.model_doubt) return false;
    return result.model_doubt->tile_rotation > kDoubtfulRotation ||
           result.model_doubt->change > kDoubtfulChange || result.solution.iterations > kDoubtfulIterations;
}

std::string model_warning(const SurfaceResult& result) {
    if (!result.solution.converged()) return "";
    const auto& error = result.model_error;
    if (!error)
        return is_doubtful(result) ? "this model may be off by more than 5 %; nothing was estimated" : "";
    if (error->largest <= kWarnedError) return "";
    char text[160];
    std::snprintf(text, sizeof text,
                  "this model is off by about %.2g %% of the largest displacement at the worst node, %.2g %% "
                  "on average",
                  100.0 * error->largest, 100.0 * error->mean);
    return text;
}

}  // namespace fretwork::simulation
