// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/model_choice.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>

#include <algorithm>
#include <iterator>

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
    const std::string full = reference_choice(session.options()).name;
    RefinedStress refined;
    refined.full_tiles = std::move(full_tiles);
    std::ranges::sort(refined.full_tiles);
    std::vector<TileIndex> missing = refined.full_tiles;
    do {
        if (!missing.empty()) session.set_tile_model(missing, full);
        refined.result = session.solve(control);
        ++refined.solutions;
        refined.table = beam_table(session, refined.result.solution);
        if (!refined.result.solution.converged() || refined.table.rows.empty()) return refined;
        const std::vector<TileIndex> around =
            tiles_around(session.surface(), most_stressed(refined.table, 1).front());
        missing.clear();
        std::ranges::set_difference(around, refined.full_tiles, std::back_inserter(missing));
        std::vector<TileIndex> all;
        std::ranges::set_union(refined.full_tiles, missing, std::back_inserter(all));
        refined.full_tiles = std::move(all);
    } while (!missing.empty());
    refined.is_settled = true;
    return refined;
}

RefinedStress refine_stress(const Surface& surface, const SurfaceResult& result,
                            const base::Control& control) {
    const ResultSubject& subject = result.subject.value();
    const std::string model = main_model(subject);
    const bool is_reduced = model == kMixedTiles || mixed_share(model).has_value();
    if (!is_reduced || result.solver == "linear" || !subject.stages_text.empty())
        throw base::InputError(
            "only a nonlinear result of corotational or mixed tiles, without stages, is refined; "
            "this one is of the model '" +
            subject.model + "', solver '" + result.solver + "'" +
            (subject.stages_text.empty() ? "" : ", in stages"));
    Session session(surface, parse_load_case(subject.load_case_text, "load case of the result"),
                    {.model = kMixedTiles});
    std::vector<TileIndex> full_tiles;
    for (const int tile : subject.full_tiles) full_tiles.emplace_back(tile);
    return refine_stress(session, std::move(full_tiles), control);
}

}  // namespace fretwork::simulation
