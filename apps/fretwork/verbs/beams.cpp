// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork beams: what the beams of a surface bear in a result.
#include "bar_checks.hpp"
#include "interrupt.hpp"
#include "options/file_options.hpp"
#include "surface_result.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/results/beam_table.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/stress_refinement.hpp>
#include <fretwork/simulation/stages.hpp>

#include <cstdio>
#include <memory>

namespace fretwork::app {
namespace {

struct BeamsOptions {
    std::string project;
    std::string result;
    std::string library;
    std::string strength;
    std::string out;
    std::size_t top = 10;
    bool refine = false;
    bool json = false;
};

simulation::Surface read_surface(const BeamsOptions& options, const simulation::SurfaceResult& result) {
    const simulation::Project project = simulation::read_checked_project(options.project);
    const bool is_calibrated = simulation::needs_library(
        project, simulation::model_choice({.model = simulation::main_model(*result.subject)}));
    std::optional<library::Library> library;
    if (!options.library.empty() || !project.setting || is_calibrated)
        library = simulation::open_project_library(options.project, project, options.library);
    return simulation::make_surface(project, library ? &*library : nullptr);
}

/// Prints the load stages after which the beams bear these forces.
void print_stages(const simulation::SurfaceResult& result) {
    std::vector<std::string> names;
    for (const std::string& name : simulation::stage_names(result))
        names.push_back("'" + base::printable(name) + "'");
    if (!names.empty()) std::printf("after the stages %s\n", base::join(names, ", ").c_str());
}

void print(const simulation::BeamTable& table, const simulation::Surface& surface, std::size_t top) {
    const auto& tessellation = surface.tessellation;
    std::printf("joints: %s\n", std::string(reduction::joints_name(table.joints)).c_str());
    std::printf("%6s %6s  %-20s %9s %9s %10s %10s %10s%s\n", "beam", "tile", "pattern", "x mm", "y mm", "N",
                "normal MPa", "Mises MPa", table.strength ? "   share of strength" : "");
    for (const simulation::BeamRow& row : simulation::most_stressed(table, top)) {
        const int pattern = tessellation.tiles[row.tile].pattern;
        const std::size_t worse = row.von_mises[0] >= row.von_mises[1] ? 0 : 1;
        const Eigen::Vector3d& place = row.places[worse];
        std::printf("%6zu %6d  %-20s %9.1f %9.1f %10.4g %10.4g %10.4g", row.beam, row.tile.value,
                    tessellation.patterns[static_cast<std::size_t>(pattern)].id.c_str(), 1e3 * place.x(),
                    1e3 * place.y(), row.forces[worse].N, 1e-6 * row.stress[worse],
                    1e-6 * row.von_mises[worse]);
        if (const auto share = table.utilization(row)) std::printf("   %.1f %%", 100.0 * *share);
        std::puts("");
    }
    if (table.strength)
        std::printf("share of strength: %s\n", simulation::utilization_formula(table).c_str());
    if (table.unknown > 0) std::printf("%zu beams are not known with this result's model\n", table.unknown);
}

/// The stress of the result with the tiles around its most stressed beam in full.
simulation::BeamTable refined_table(const simulation::Surface& surface,
                                    const simulation::SurfaceResult& result, const BeamsOptions& options) {
    LongWork work;
    const simulation::RefinedStress refined = simulation::refine_stress(surface, result, work.control());
    if (!refined.is_settled)
        throw base::NumericalError(
            "no equilibrium was found with the tiles around the most stressed beam in full");
    if (!options.json)
        std::printf(
            "solved %d times; %zu tiles are in full, among them those around the most stressed beam\n",
            refined.solutions, refined.full_tiles.size());
    return refined.table;
}

ExitCode run(const BeamsOptions& options) {
    const simulation::SurfaceResult result = read_surface_result(options.result);
    const simulation::Surface surface = read_surface(options, result);
    check_subject_of(simulation::surface_identity(surface), result, options.result);
    simulation::BeamTable table =
        options.refine ? refined_table(surface, result, options) : simulation::beam_table(surface, result);
    if (!options.strength.empty()) table.strength = parse_strength(options.strength);
    const bool is_known = !table.rows.empty();
    if (!options.out.empty()) {
        const bool is_csv = base::ending_of(options.out) == ".csv";
        base::write_file_atomically(options.out, is_csv ? simulation::beam_table_csv(table, surface)
                                                        : simulation::beam_table_json(table, surface));
    }
    if (options.json) {
        table.rows = simulation::most_stressed(table, options.top);
        std::fputs(simulation::beam_table_json(table, surface).c_str(), stdout);
    } else {
        print_stages(result);
        print(table, surface, options.top);
    }
    return is_known ? ExitCode::Done : ExitCode::DidNotSucceed;
}

}  // namespace

void add_beams(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "beams", "List section forces, stress and utilization of every beam in a result, the worst first");
    const auto options = std::make_shared<BeamsOptions>();
    verb->add_option("project", options->project, "Project file")->required();
    verb->add_option("result", options->result, "Result file of this project")->required();
    verb->add_option("--top", options->top, "Number of beams to print")
        ->check(CLI::Range(0, 1'000'000'000))
        ->capture_default_str();
    verb->add_option("--strength", options->strength,
                     "Strength of the material, such as 40MPa (default: that of the setting's material)")
        ->type_name("STRESS");
    verb->add_flag("--refine", options->refine,
                   "Solve again with the tiles around the most stressed beam in full, until the most "
                   "stressed beam lies in such a tile (nonlinear results of corotational and mixed tiles)");
    verb->add_option("--library", options->library, "Library with the setting (default: the project's)");
    verb->add_option("--out", options->out, "Table of all beams to write: .csv or .json");
    verb->add_flag("--json", options->json, "Print JSON");
    declare_files(*verb,
                  {input("project"), input("result"), input("--library"), output("--out", kBeamTableFile)});
    verb->footer(
        "Stresses are the largest over the section at each end: normal, and von Mises with shear and "
        "torsion.\n"
        "A section without a shape counts as the rectangle with its radii of gyration. SI in "
        "files.\n"
        "Example: fretwork beams project.json full.json --strength 40MPa --out beams.csv");
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace fretwork::app
