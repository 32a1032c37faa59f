// SPDX-License-Identifier: GPL-3.0-or-later
// Which ranking of tiles finds those that are best put in full: the errors of one surface under one load
// case, by each ranking. See README.md.
#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/mixed_model.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace {

using namespace fretwork;
using simulation::TileDeformation;

struct Ranking {
    const char* name;
    double (*score)(const TileDeformation&);
};

constexpr Ranking kRankings[] = {
    {"energy_rotation", [](const TileDeformation& tile) { return tile.energy * tile.rotation; }},
    {"energy", [](const TileDeformation& tile) { return tile.energy; }},
    {"rotation", [](const TileDeformation& tile) { return tile.rotation; }},
    {"energy2_rotation",
     [](const TileDeformation& tile) { return tile.energy * tile.energy * tile.rotation; }},
};

simulation::SimulationOptions with_model(const std::string& model) {
    simulation::SimulationOptions options;
    options.model = model;
    return options;
}

/// The surface with a given number of its tiles in full, those of the largest scores.
simulation::Surface with_full_tiles(simulation::Surface surface, const std::vector<TileDeformation>& tiles,
                                    const Ranking& ranking, std::size_t count) {
    std::vector<std::size_t> order(tiles.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, std::greater(),
                             [&](std::size_t tile) { return ranking.score(tiles[tile]); });
    order.resize(count);
    surface.tile_models.assign(tiles.size(), "");
    for (const std::size_t tile : order) surface.tile_models[tile] = "full";
    return surface;
}

/// Mean errors over the largest displacement: of corotational tiles, and with each ranking.
base::Json mean_errors(const simulation::Surface& surface, const simulation::LoadCase& load_case,
                       double share) {
    const simulation::SurfaceResult full = simulate(surface, load_case, with_model("full"));
    const auto error = [&](const simulation::SurfaceResult& result) {
        const simulation::Comparison comparison = simulation::compare(full, result);
        return comparison.mean_translation_error / comparison.max_displacement;
    };
    simulation::Session session(surface, load_case, with_model("corotational"));
    simulation::SurfaceResult corotational = session.solve();
    const std::vector<TileDeformation> tiles = session.tile_deformations(corotational.solution);
    const std::size_t count = simulation::worst_tiles(tiles, share).size();
    base::Json errors = {{"corotational", error(corotational)}};
    for (const Ranking& ranking : kRankings)
        errors[ranking.name] = error(
            simulate(with_full_tiles(surface, tiles, ranking, count), load_case, with_model("corotational")));
    return errors;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "The mean error of a surface with a share of its tiles in full, by what tiles are ranked by");
    std::string project_file;
    std::string load_case_file;
    double share = 0.05;
    app.add_option("project", project_file, "Project file")->required();
    app.add_option("case", load_case_file, "Load case file")->required();
    app.add_option("--share", share, "Of the tiles, in full")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        const simulation::Surface surface =
            simulation::make_surface(simulation::read_checked_project(project_file), nullptr);
        std::fputs(
            base::json_text(mean_errors(surface, simulation::read_load_case(load_case_file), share)).c_str(),
            stdout);
    } catch (const base::InputError& error) {
        std::fprintf(stderr, "large_deflection_rankings: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "large_deflection_rankings: %s\n", error.what());
        return 1;
    }
}
