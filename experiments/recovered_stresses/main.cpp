// SPDX-License-Identifier: GPL-3.0-or-later
// How near the stresses of a surface of corotational tiles are to those of the full model, by the way in
// which they are recovered. See README.md.
#include "recoveries.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/results/comparison.hpp>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

namespace {

using namespace fretwork;
using recovered_stresses::Recoveries;
using recovered_stresses::Stresses;
using simulation::SurfaceResult;

struct Way {
    const char* name;
    Stresses (Recoveries::*recover)(const SurfaceResult&) const;
};
constexpr Way kWays[] = {{"linear", &Recoveries::linear},
                         {"large_beams", &Recoveries::large_beams},
                         {"held_tiles", &Recoveries::held_tiles},
                         {"loaded_tiles", &Recoveries::loaded_tiles},
                         {"sprung_softly", &Recoveries::sprung_softly},
                         {"sprung", &Recoveries::sprung},
                         {"sprung_stiffly", &Recoveries::sprung_stiffly},
                         {"built_in", &Recoveries::built_in}};

simulation::Session session_of(const simulation::Surface& surface, const simulation::LoadCase& load_case,
                               const char* model) {
    simulation::SimulationOptions options;
    options.model = model;
    return {surface, load_case, options};
}

/// Of the largest stress, as a share of it; and of all, root mean square over that of the truth.
base::Json errors(const Stresses& stresses, const Stresses& truth) {
    return {{"largest", std::abs(stresses.maxCoeff() - truth.maxCoeff()) / truth.maxCoeff()},
            {"rms", (stresses - truth).norm() / truth.norm()}};
}

base::Json answer(const simulation::Surface& surface, const simulation::LoadCase& load_case) {
    simulation::Session full = session_of(surface, load_case, "full");
    simulation::Session reduced = session_of(surface, load_case, "corotational");
    const SurfaceResult reference = full.solve();
    const SurfaceResult result = reduced.solve();
    if (!reference.solution.converged() || !result.solution.converged()) return {{"converged", false}};
    const simulation::Comparison comparison = simulation::compare(reference, result);
    const Stresses truth = Recoveries(full).built_in(reference);
    double rotation = 0.0;
    for (const auto& tile : reduced.tile_deformations(result.solution))
        rotation = std::max(rotation, tile.rotation);
    base::Json json = {
        {"converged", true},
        {"tiles", surface.tessellation.tiles.size()},
        {"solve_ms", 1e3 * result.seconds},
        {"tile_rotation", rotation},
        {"displacement_largest", comparison.max_translation_error / comparison.max_displacement}};
    const Recoveries recoveries(reduced);
    for (const Way& way : kWays) {
        try {
            const auto started = std::chrono::steady_clock::now();
            const Stresses stresses = (recoveries.*way.recover)(result);
            json[way.name] = errors(stresses, truth);
            json[way.name]["ms"] =
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started).count();
        } catch (const base::NumericalError& error) {
            json[way.name] = {{"failed", error.what()}};
        }
    }
    // The interface nodes where the full model has them: what is left is the error of the recovery alone.
    SurfaceResult exact = result;
    const auto nodes = std::ssize(surface.tessellation.interface_nodes);
    exact.solution.displacements = reference.solution.displacements.topRows(nodes);
    json["linear_from_full"] = errors(recoveries.linear(exact), truth);
    json["held_from_full"] = errors(recoveries.held_tiles(exact), truth);
    return json;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("The errors of the beams' stresses of corotational tiles, by how they are recovered");
    std::string project_file;
    std::string load_case_file;
    app.add_option("project", project_file, "Project file")->required();
    app.add_option("case", load_case_file, "Load case file")->required();
    app.footer("Example: recovered_stresses project.json case.json");
    CLI11_PARSE(app, argc, argv);
    try {
        const simulation::Surface surface =
            simulation::make_surface(simulation::read_checked_project(project_file), nullptr);
        std::fputs(base::json_text(answer(surface, simulation::read_load_case(load_case_file))).c_str(),
                   stdout);
    } catch (const base::InputError& error) {
        std::fprintf(stderr, "recovered_stresses: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "recovered_stresses: %s\n", error.what());
        return 1;
    }
}
