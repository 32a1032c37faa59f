// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork simulate: a project under one of its load cases, with the full or a reduced model.
#include "interrupt.hpp"
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "output.hpp"
#include "verbs.hpp"
#include "verbs/solve_output.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/tables/series_files.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/results/comparison.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/surface_linear_range.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/simulation/stages.hpp>
#include <fretwork/simulation/surface_frame.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace fretwork::app {
namespace {

using simulation::LoadCase;
using simulation::Project;
using simulation::Surface;

struct SimulateOptions {
    std::string project;
    std::string load_case;
    std::string library;
    std::string out;
    std::string frame_out;
    std::string deck;
    std::string branch = "primary";
    std::string stages;
    std::string series;
    std::vector<std::string> drawings;  ///< a VTU and an SVG file, where asked for
    bool linear = false;
    bool json = false;
    simulation::SimulationOptions simulation;
};

/// Errors of a project's load cases or frame name its file.
template <class Work>
auto of_project(const SimulateOptions& options, const Work& work) {
    return base::located(options.project, "", work);
}

/// The name of a load case of the project; else a file is one by its ending or its folder.
LoadCase chosen_load_case(const Project& project, const SimulateOptions& options) {
    const std::string& name_or_file = options.load_case;
    for (const LoadCase& own : project.load_cases) {
        if (own.name == name_or_file)
            return of_project(options, [&] { return simulation::find_load_case(project, name_or_file); });
    }
    const std::filesystem::path path(name_or_file);
    if (path.extension() == ".json" || path.has_parent_path())
        return simulation::combined(simulation::read_load_case(path), project.load_cases);
    return of_project(options, [&] { return simulation::find_load_case(project, name_or_file); });
}

std::string numbers_text(const std::vector<int>& numbers) {
    std::vector<std::string> texts;
    for (const int number : numbers) texts.push_back(std::to_string(number));
    return base::join(texts, ", ");
}

void print_model_error(const simulation::ModelError& error) {
    std::printf(
        "error of the model, estimated: %.2g %% of the largest displacement on average, %.2g %% at most",
        100.0 * error.mean, 100.0 * error.largest);
    if (error.largest_stress) std::printf("; %.2g %% of the largest stress", 100.0 * *error.largest_stress);
    std::puts("");
}

/// Null if it was not asked for, or is not known.
base::Json model_error_json(const simulation::SurfaceResult& result) {
    const auto& error = result.model_error;
    if (!error) return nullptr;
    return {{"mean", error->mean},
            {"largest", error->largest},
            {"relative_l2", error->relative_l2},
            {"full_share", error->full_share},
            {"largest_stress", base::or_null(error->largest_stress)}};
}

/// Null of linear results and of the full model.
base::Json model_doubt_json(const simulation::SurfaceResult& result) {
    const auto& doubt = result.model_doubt;
    if (!doubt) return nullptr;
    return {{"tile_rotation", doubt->tile_rotation},
            {"change", doubt->change},
            {"is_large", simulation::is_doubtful(result)}};
}

base::Json linear_range_json(const simulation::SurfaceResult& result) {
    const auto& range = result.linear_range;
    if (!range) return nullptr;
    return {{"error_estimate", range->error},
            {"loses_stability", range->loses_stability},
            {"is_exceeded", simulation::is_exceeded(*range)}};
}

base::Json values_of(const std::vector<mechanics::Mode>& modes) {
    base::Json values = base::Json::array();
    for (const mechanics::Mode& mode : modes) values.push_back(mode.value);
    return values;
}

base::Json stability_losses_json(const simulation::SurfaceResult& result) {
    base::Json losses = base::Json::array();
    for (const mechanics::StabilityLoss& loss : result.solution.stability_losses)
        losses.push_back({{"load_factor", loss.load_factor},
                          {"node", result.nodes[loss.node].id},
                          {"component", mechanics::kDofNames[static_cast<std::size_t>(loss.dof)]},
                          {"pushed", loss.pushed}});
    return losses;
}

/// What the user has to be told of a result whose model may be wrong.
std::vector<std::string> warnings_of(const simulation::SurfaceResult& result) {
    std::vector<std::string> warnings;
    if (simulation::is_out_of_range(result))
        warnings.push_back(simulation::linear_doubt_text(result) +
                           "; --model full, without --linear, or corotational tell");
    if (const std::string warning = simulation::model_warning(result); !warning.empty())
        warnings.push_back(warning + "; --model full tells");
    return warnings;
}

void print_json(const simulation::SurfaceResult& result) {
    const auto& solution = result.solution;
    const simulation::ResultSubject& subject = result.subject.value();
    print_document({{"model", subject.model},
                    {"load_case", subject.load_case},
                    {"joints", reduction::joints_name(subject.joints.value())},
                    {"solver", result.solver},
                    {"converged", solution.converged()},
                    {"stable", solution.stable},
                    {"termination", mechanics::termination_name(solution.termination)},
                    {"largest_displacement", simulation::largest_displacement(result, solution)},
                    {"largest_rotation", simulation::largest_rotation(result, solution)},
                    {"iterations", solution.iterations},
                    {"discretization_error", discretization_json(result)},
                    {"full_tiles", subject.full_tiles},
                    {"model_doubt", model_doubt_json(result)},
                    {"model_error_estimate", model_error_json(result)},
                    {"buckled_tiles", base::or_null(result.buckled_tiles)},
                    {"linear_range", linear_range_json(result)},
                    {"fit_error", base::or_null(result.fit_error)},
                    {"warnings", warnings_of(result)},
                    {"stability_losses", stability_losses_json(result)},
                    {"frequencies", values_of(result.vibration_modes)},
                    {"buckling_load_factors", values_of(result.buckling_modes)},
                    {"seconds", result.seconds}});
}

/// Each solution of a path with several.
void print_steps(const simulation::SurfaceResult& result) {
    for (std::size_t i = 0; i < result.load_steps.size(); ++i) {
        const mechanics::Solution& step = result.load_steps[i];
        std::printf("  %zu: %s at %.3g, largest displacement %.4g mm\n", i + 1,
                    std::string(mechanics::termination_name(step.termination)).c_str(), step.load_factor,
                    1e3 * simulation::largest_displacement(result, step));
        for (const mechanics::StabilityLoss& loss : step.stability_losses)
            std::printf("     jumped at %.4g: %s\n", loss.load_factor, component_text(result, loss).c_str());
    }
}

void print(const simulation::SurfaceResult& result, const Wanted& wanted) {
    const auto& solution = result.solution;
    const simulation::ResultSubject& subject = result.subject.value();
    std::printf("%s model, joints: %s, load case '%s', %s: %s%s\n", base::printable(subject.model).c_str(),
                std::string(reduction::joints_name(subject.joints.value())).c_str(),
                base::printable(subject.load_case).c_str(), result.solver.c_str(),
                std::string(mechanics::termination_name(solution.termination)).c_str(),
                solution.stable ? "" : ", unstable");
    if (!solution.converged()) print_failure(result, wanted.branch);
    std::printf("largest displacement %.4g mm, largest rotation %.4g deg (interface nodes), %.3g s\n",
                1e3 * simulation::largest_displacement(result, solution),
                simulation::largest_rotation(result, solution) * kDegreesPerRadian, result.seconds);
    print_losses_and_modes(result, wanted);
    if (const auto& error = result.discretization_error)
        std::printf("%s\n", discretization_text(*error).c_str());
    if (!subject.full_tiles.empty())
        std::printf("tiles in full: %s\n", numbers_text(subject.full_tiles).c_str());
    if (const auto& error = result.model_error) print_model_error(*error);
    if (result.buckled_tiles && !result.buckled_tiles->empty())
        std::printf("tiles whose beams buckle between their interface nodes: %s\n",
                    numbers_text(*result.buckled_tiles).c_str());
}

/// The result drawn or for ParaView, as `export` would write it.
void add_drawings(const SimulateOptions& options, const Surface& surface,
                  const simulation::SurfaceResult& result, base::FileBatch& files) {
    if (options.drawings.empty()) return;
    exports::Scene scene{surface};
    scene.results.push_back({options.simulation.model, result});
    for (const std::string& path : options.drawings)
        files.add(path, exports::find_writer(path).write(scene).text);
}

/// The load steps or stages for ParaView. The files beside the named one are ours, or do not exist.
void add_series(const SimulateOptions& options, const Surface& surface,
                const simulation::SurfaceResult& result, base::FileBatch& files) {
    if (options.series.empty()) return;
    const std::filesystem::path path(options.series);
    for (const exports::NamedFile& file :
         exports::series_files(surface, result, path.stem().string(), surface.setting.strength)) {
        const std::filesystem::path place = path.parent_path() / file.name;
        if (std::filesystem::exists(place) && !says_who_made_it(base::read_text_file(place)))
            throw base::InputError(place.string(), "",
                                   "is there, and not made by fretwork: it is not replaced by a step of " +
                                       path.filename().string());
        files.add(place, file.text);
    }
}

/// Every beam of every tile, whatever models the tiles have.
mechanics::Frame full_frame(Surface surface, const LoadCase& load_case) {
    surface.tile_models.clear();
    return simulation::surface_frame(surface, {}, simulation::resolve(load_case, surface));
}

/// Numerical errors name the project.
simulation::SurfaceResult simulate(const SimulateOptions& options, const Surface& surface,
                                   const LoadCase& load_case, const std::vector<LoadCase>& cases,
                                   const base::Control& control) {
    return base::located<base::NumericalError>(options.project, "", [&] {
        if (options.stages.empty())
            return simulation::simulate(surface, load_case, options.simulation, control);
        const std::vector<simulation::LoadStage> stages = simulation::read_stages(options.stages);
        return simulation::simulate_stages(surface, {load_case, cases, stages}, options.simulation, control);
    });
}

ExitCode run(SimulateOptions options) {
    LongWork work;
    if (options.linear) options.simulation.analysis = simulation::Analysis::Linear;
    options.simulation.branch = mechanics::find_branch(options.branch);
    options.simulation.estimate_linear_range = true;
    options.simulation.estimate_where_doubtful = true;
    const Project project = simulation::read_checked_project(options.project);
    const simulation::ModelChoice choice = simulation::model_choice(options.simulation);
    std::optional<library::Library> library;
    if (!options.library.empty() || simulation::needs_library(project, choice))
        library = simulation::open_project_library(options.project, project, options.library);
    const Surface surface = simulation::make_surface(project, library ? &*library : nullptr);
    options.simulation.validate(surface);
    simulation::check_calibrations(options.project, project, surface, choice);
    if (const std::string foreign = simulation::foreign_size_text(surface, choice); !foreign.empty())
        warn(foreign);
    const LoadCase load_case = chosen_load_case(project, options);
    base::FileBatch files;
    if (!options.frame_out.empty() || !options.deck.empty()) {
        const mechanics::Frame frame = full_frame(surface, load_case);
        if (!options.frame_out.empty()) files.add(options.frame_out, mechanics::frame_text(frame));
        if (!options.deck.empty())
            files.add(options.deck, of_project(options, [&] {
                          return mechanics::calculix_text(frame, mechanics::DeckReader::Calculix);
                      }));
    }
    const simulation::SurfaceResult result =
        simulate(options, surface, load_case, project.load_cases, work.control());
    files.add(options.out, simulation::surface_result_text(result));
    add_drawings(options, surface, result, files);
    add_series(options, surface, result, files);
    files.commit();
    options.json ? print_json(result)
                 : print(result, {options.simulation.vibration_modes, options.simulation.buckling_modes,
                                  options.simulation.branch});
    if (!options.json && !options.stages.empty()) print_steps(result);
    for (const std::string& warning : warnings_of(result)) warn(warning);
    const bool misses_error = options.simulation.estimate_model_error && !result.model_error;
    if (misses_error) warn("the error of the model is not known: no better solution was found");
    return result.solution.converged() && !misses_error ? ExitCode::Done : ExitCode::DidNotSucceed;
}

std::string models_help() {
    std::string text = "Model:";
    for (const reduction::TileModel& model : reduction::tile_models())
        text += "\n  " + model.name + ": " + model.summary;
    text += "\n  mixed:SHARE: corotational, with that share of the tiles, the worst, in full (mixed:0.05)";
    return text;
}

void add_what_to_solve(CLI::App& verb, SimulateOptions& options) {
    verb.add_option("project", options.project, "Project file")->required();
    verb.add_option("--case", options.load_case, "Name of a load case of the project, or a load case file");
    verb.add_option("--model", options.simulation.model, models_help())->capture_default_str();
    verb.add_flag("--linear", options.linear, "Small displacements, whatever the model");
    verb.add_option("--branch", options.branch,
                    "Equilibria to follow where the path becomes unstable: primary stays on the path, "
                    "stable leaves it along the critical mode, snapping also continues beyond limit loads, "
                    "at a stable equilibrium of lower energy")
        ->check(CLI::IsMember(mechanics::branch_names()))
        ->capture_default_str();
    verb.add_option("--stages", options.stages,
                    "File of load stages, one after the other: loads, displacements, components kept and "
                    "released; supports are those of --case");
}

void add_answers(CLI::App& verb, SimulateOptions& options) {
    verb.add_option("--modes", options.simulation.vibration_modes,
                    "Number of natural frequencies of the surface at rest, with all of its beams")
        ->check(CLI::Range(0, 1000));
    verb.add_option("--buckling", options.simulation.buckling_modes,
                    "Number of critical load factors by linearized buckling, with all of its beams")
        ->check(CLI::Range(0, 1000));
    verb.add_option("--steps", options.simulation.load_steps,
                    "Number of equal load steps, each with a result")
        ->capture_default_str();
    verb.add_flag("--estimate-error", options.simulation.estimate_error,
                  "Estimate the error of the full model relative to ever finer divisions of its beams");
    verb.add_flag("--estimate-model-error", options.simulation.estimate_model_error,
                  "Estimate the error of a reduced model relative to the full one, in displacement and in "
                  "the largest stress, by a solution with more of the tiles in full: 30 %, for mixed models "
                  "60 % more. Without this option, both errors are estimated if corotational and "
                  "mixed tiles are themselves strongly deformed");
    verb.add_option("--threads", options.simulation.threads, "Threads to use; 0: one for each processor")
        ->check(thread_check())
        ->capture_default_str();
}

void add_files(CLI::App& verb, SimulateOptions& options) {
    verb.add_option("--library", options.library,
                    "Library with the setting and the calibrations (default: the project's)");
    verb.add_option("--out", options.out, "Result file")->required();
    verb.add_option("--frame-out", options.frame_out, "Write the full model as a frame file, too");
    verb.add_option("--deck", options.deck,
                    "Write the full model as an input deck for CalculiX, too: ccx -i NAME runs it");
    for (const std::string ending : {"vtu", "svg"}) {
        verb.add_option_function<std::string>(
            "--" + ending, [&options](const std::string& path) { options.drawings.push_back(path); },
            "Write the displaced beams as ." + ending + ", too");
    }
    verb.add_option("--series", options.series,
                    "Write the load steps or stages as a series for ParaView, too: this .pvd, and a .vtu for "
                    "each beside it");
}

}  // namespace

void add_simulate(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "simulate", "Simulate a project under a load case, with the full or a reduced model");
    const auto options = std::make_shared<SimulateOptions>();
    add_what_to_solve(*verb, *options);
    add_answers(*verb, *options);
    add_files(*verb, *options);
    verb->add_flag("--json", options->json, "Print JSON");
    declare_files(
        *verb, {input("project"), input("--case"), input("--stages"), input("--library"),
                output("--out", kResultFile), output("--frame-out", kFrameFile), output("--deck", kDeckFile),
                output("--vtu", kVtuFile), output("--svg", kSvgFile), output("--series", kSeriesFile)});
    verb->footer(
        "Example: fretwork simulate project.json --case cantilever --model condensed --out reduced.json");
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace fretwork::app
