// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/model_choice.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace fretwork::simulation {

using tiling::TileIndex;

std::vector<TileIndex> tiles_around(const Surface& surface, const BeamRow& beam) {
    const auto& tiles = surface.tessellation.tiles;
    std::vector<tiling::InterfaceIndex> own = tiles[beam.tile].interface_nodes;
    std::ranges::sort(own);
    std::vector<TileIndex> around;
    for (const TileIndex tile : tiles.indices()) {
        const bool is_painted = tiles[tile].pattern >= 0;
        const bool touches = std::ranges::any_of(
            tiles[tile].interface_nodes, [&](auto node) { return std::ranges::binary_search(own, node); });
        if (is_painted && touches) around.push_back(tile);
    }
    return around;
}

RefinedStress refine_stress(Session& session, std::vector<TileIndex> full_tiles,
                            const base::Control& control) {
    std::ranges::sort(full_tiles);
    if (!full_tiles.empty()) session.set_tile_model(full_tiles, reference_choice(session.options()).name);
    SurfaceResult first = session.solve(control);
    return refine_stress(session, std::move(first), std::move(full_tiles), control);
}

RefinedStress refine_stress(Session& session, SurfaceResult first, std::vector<TileIndex> full_tiles,
                            const base::Control& control) {
    RefinedStress refined{.result = std::move(first), .full_tiles = std::move(full_tiles), .solutions = 1};
    while (true) {
        if (!refined.result.solution.converged()) return refined;
        refined.table = beam_table(session, refined.result.solution, control);
        if (refined.table.rows.empty()) return refined;
        const std::vector<TileIndex> around =
            tiles_around(session.surface(), most_stressed(refined.table, 1).front());
        std::vector<TileIndex> missing;
        std::ranges::set_difference(around, refined.full_tiles, std::back_inserter(missing));
        refined.is_settled = missing.empty();
        if (refined.is_settled) return refined;
        refined.full_tiles.insert(refined.full_tiles.end(), missing.begin(), missing.end());
        std::ranges::sort(refined.full_tiles);
        session.set_tile_model(missing, reference_choice(session.options()).name);
        refined.result = session.solve(control);
        ++refined.solutions;
    }
}

RefinedStress refine_stress(const Surface& surface, const SurfaceResult& result,
                            const base::Control& control) {
    const ResultSubject& subject = result.subject.value();
    const std::string model = main_model(subject);
    const bool is_reduced = model == kMixedTiles || mixed_share(model).has_value();
    if (!is_reduced || result.solver == "linear" || !subject.stages_text.empty())
        throw base::InputError(
            "only a nonlinear result of corotational or mixed tiles, without load stages, is refined; "
            "this one is of the model '" +
            subject.model + "', solver '" + result.solver + "'" +
            (subject.stages_text.empty() ? "" : ", in load stages"));
    Session session(surface, parse_load_case(subject.load_case_text, "load case of the result"),
                    {.model = kMixedTiles});
    std::vector<TileIndex> full_tiles;
    for (const int tile : subject.full_tiles) full_tiles.emplace_back(tile);
    return refine_stress(session, std::move(full_tiles), control);
}

}  // namespace fretwork::simulation
