// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork simulate: a project under one of its load cases, with the full or a reduced model.
#include "interrupt.hpp"
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "output.hpp"
#include "program.hpp"
#include "verbs.hpp"
#include "verbs/simulate_output.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/exports/tables/series_files.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/simulation/stages.hpp>
#include <fretwork/simulation/surface_frame.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// A load case, and the file that has it.
struct ChosenCase {
    LoadCase load_case;
    std::string file;
};

/// The project's load case with this name. Another text is a file if it ends in .json or has a folder.
ChosenCase chosen_load_case(const Project& project, const SimulateOptions& options) {
    const std::string& name_or_file = options.load_case;
    const bool is_own =
        std::ranges::find(project.load_cases, name_or_file, &LoadCase::name) != project.load_cases.end();
    const std::filesystem::path path(name_or_file);
    if (!is_own && (base::ending_of(path) == ".json" || path.has_parent_path())) {
        const LoadCase read = simulation::read_load_case(path);
        return {
            base::located(name_or_file, "", [&] { return simulation::combined(read, project.load_cases); }),
            name_or_file};
    }
    return {of_project(options, [&] { return simulation::find_load_case(project, name_or_file); }),
            options.project};
}

/// A file that is still to be written.
struct ResultText {
    std::filesystem::path path;
    std::string text;
};

/// Adds the result as a drawing or for ParaView, as `export` would write it.
void add_drawings(const SimulateOptions& options, const Surface& surface,
                  const simulation::SurfaceResult& result, std::vector<ResultText>& files) {
    if (options.drawings.empty()) return;
    exports::Scene scene{surface};
    scene.results.push_back({options.simulation.model, result});
    for (const std::string& path : options.drawings)
        files.push_back({path, exports::find_writer(path).write(scene).text});
}

/// Adds the load steps or stages for ParaView, each as a file beside the named one. Throws InputError if such
/// a file exists and fretwork has not made it.
void add_series(const SimulateOptions& options, const Surface& surface,
                const simulation::SurfaceResult& result, std::vector<ResultText>& files) {
    if (options.series.empty()) return;
    const std::filesystem::path path(options.series);
    for (exports::NamedFile& file :
         exports::series_files(surface, result, path.stem().string(), surface.setting.strength)) {
        const std::filesystem::path place = path.parent_path() / file.name;
        if (std::filesystem::exists(place) && !says_who_made_it(base::read_text_file(place)))
            throw base::InputError(place.string(), "",
                                   "is there, and not made by fretwork: it is not replaced by a step of " +
                                       path.filename().string());
        files.push_back({place, std::move(file.text)});
    }
}

/// Every beam of every tile, whatever models the tiles have.
mechanics::Frame full_frame(Surface surface, const LoadCase& load_case) {
    surface.tile_models.clear();
    return simulation::surface_frame(surface, {}, simulation::resolve(load_case, surface));
}

/// The frame file and the deck, where asked for.
std::vector<ResultText> frame_files(const SimulateOptions& options, const Surface& surface,
                                    const LoadCase& load_case) {
    std::vector<ResultText> files;
    if (options.frame_out.empty() && options.deck.empty()) return files;
    const mechanics::Frame frame = full_frame(surface, load_case);
    if (!options.frame_out.empty()) files.push_back({options.frame_out, mechanics::frame_text(frame)});
    if (!options.deck.empty())
        files.push_back({options.deck, of_project(options, [&] {
                             return mechanics::calculix_text(frame, mechanics::DeckProgram::Calculix);
                         })});
    return files;
}

/// Writes all files or none. Scratch files exist only here, so here alone Ctrl-C is a request: it is answered
/// before the first file is replaced.
void write_results(const std::vector<ResultText>& files) {
    LongWork work;
    base::FileBatch batch;
    for (const ResultText& file : files) {
        work.control().check();
        batch.add(file.path, file.text);
    }
    work.control().check();
    batch.commit();
}

/// Numerical errors name the project, errors of load stages their file.
simulation::SurfaceResult simulate(const SimulateOptions& options, const Surface& surface,
                                   const simulation::StagePlan& plan, const base::Control& control) {
    return base::located<base::NumericalError>(options.project, "", [&] {
        if (options.stages.empty())
            return simulation::simulate(surface, *plan.supports, options.simulation, control);
        return base::located(options.stages, "", [&] {
            return simulation::simulate_stages(surface, plan, options.simulation, control);
        });
    });
}

/// Refuses a file of the command line that is a step of the series, too.
void refuse_named_steps(const CLI::App& verb, const SimulateOptions& options, std::size_t stages) {
    if (options.series.empty()) return;
    const std::filesystem::path path(options.series);
    const std::size_t count =
        options.stages.empty() ? static_cast<std::size_t>(options.simulation.load_steps) : stages;
    std::vector<std::filesystem::path> steps;
    for (std::size_t step = 1; step <= count; ++step)
        steps.push_back(path.parent_path() / exports::series_step_name(path.stem().string(), step));
    check_files_beside(verb, steps);
}

/// Simulates as long as nobody asks to stop.
simulation::SurfaceResult simulate_or_stop(const SimulateOptions& options, const Surface& surface,
                                           const simulation::StagePlan& plan) {
    LongWork work;
    simulation::SurfaceResult result = simulate(options, surface, plan, work.control());
    work.control().check();
    return result;
}

// While texts are read and made, which takes seconds for a huge surface, no file is half-written: Ctrl-C ends
// the program at once.
ExitCode run(const CLI::App& verb, SimulateOptions options) {
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
    std::vector<simulation::LoadStage> stages;
    if (!options.stages.empty()) stages = simulation::read_stages(options.stages);
    refuse_named_steps(verb, options, stages.size());
    simulation::check_calibrations(options.project, project, surface, choice);
    if (const std::string foreign = simulation::foreign_size_text(surface, choice); !foreign.empty())
        warn(foreign);
    const auto [load_case, case_file] = chosen_load_case(project, options);
    // Load stages take no loads of the case. Without them, errors of its entries name its file here.
    if (stages.empty())
        base::located(case_file, "", [&] { simulation::check_selections(load_case, project.tessellation); });
    std::vector<ResultText> files = frame_files(options, surface, load_case);
    const simulation::SurfaceResult result =
        simulate_or_stop(options, surface, {load_case, project.load_cases, stages});
    files.push_back({options.out, simulation::surface_result_text(result)});
    add_drawings(options, surface, result, files);
    add_series(options, surface, result, files);
    write_results(files);
    options.json ? print_result_json(result)
                 : print_result(result, {options.simulation.vibration_modes,
                                         options.simulation.buckling_modes, options.simulation.branch});
    for (const std::string& warning : warnings_of(result)) warn(warning);
    const bool misses_error = options.simulation.estimate_model_error && !result.model_error;
    if (misses_error) warn("the error of the model is not known: no better solution was found");
    return result.solution.converged() && !misses_error ? ExitCode::Done : ExitCode::DidNotSucceed;
}

/// Load stages have loads of their own, and no full load for load steps, buckling or a deck.
void refuse_beside_stages(const CLI::App& verb, const SimulateOptions& options) {
    if (options.stages.empty()) return;
    refuse_given(verb, {"--deck", "--frame-out", "--buckling", "--steps"},
                 "is for a load case alone, and would ignore --stages: leave one of the two out");
}

std::string models_help() {
    std::string text = "Model:";
    for (const reduction::TileModel& model : reduction::tile_models())
        text += "\n  " + model.name + ": " + model.summary;
    text +=
        "\n"
        "  mixed:SHARE: corotational, but with every beam in this share of the tiles, where corotational is "
        "worst (mixed:0.05)";
    return text;
}

void add_what_to_solve(CLI::App& verb, SimulateOptions& options) {
    verb.add_option("project", options.project, "Project file")->required();
    verb.add_option(
        "--case", options.load_case,
        "Name of a load case of the project, or a load case file (default: the only one of the project)");
    verb.add_option("--model", options.simulation.model, models_help())->capture_default_str();
    verb.add_flag("--linear", options.linear,
                  "Solve for small displacements (linear), also with a nonlinear model");
    verb.add_option("--branch", options.branch,
                    "Path to follow after a loss of stability. primary: the same path, stable or not. "
                    "stable: the stable path that branches off. snapping: as stable; at a limit load, the "
                    "surface jumps to a stable equilibrium of lower energy")
        ->check(CLI::IsMember(mechanics::branch_names()))
        ->capture_default_str();
    verb.add_option("--stages", options.stages,
                    "File of load stages, which follow each other. A stage sets factors of load cases, "
                    "prescribes displacements, and keeps or releases components. The supports are those of "
                    "--case. Excludes --steps, --buckling, --frame-out and --deck");
}

void add_answers(CLI::App& verb, SimulateOptions& options) {
    verb.add_option("--modes", options.simulation.vibration_modes,
                    "Compute this number of natural frequencies of the surface at rest, with the full model")
        ->check(CLI::Range(0, mechanics::kMostModes));
    verb.add_option(
            "--buckling", options.simulation.buckling_modes,
            "Compute this number of critical load factors by linearized buckling, with the full model")
        ->check(CLI::Range(0, mechanics::kMostModes));
    verb.add_option("--steps", options.simulation.load_steps,
                    "Number of equal load steps, each with a result")
        ->capture_default_str();
    verb.add_flag("--estimate-error", options.simulation.estimate_error,
                  "Estimate the discretization error of the full model: its distance from the limit of ever "
                  "finer divisions of the beams");
    verb.add_flag("--estimate-model-error", options.simulation.estimate_model_error,
                  "Estimate the error of a reduced model, in displacement and in the largest stress: solve "
                  "again with every beam in the worst 30 % of the tiles (mixed:SHARE: in SHARE plus 60 %; if "
                  "tiles rotate far: in all). Without this option, the error is estimated only for "
                  "corotational and mixed models with strongly deformed tiles");
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
                    "Write the full model as an input deck for CalculiX, too; ccx -i NAME runs NAME.inp. ccx "
                    "makes solids of the beams. Rectangular bars are then up to a fifth stiffer in torsion, "
                    "so displacements, forces and moments can differ by a tenth and more");
    for (const std::string ending : {"vtu", "svg"}) {
        verb.add_option_function<std::string>(
            "--" + ending, [&options](const std::string& path) { options.drawings.push_back(path); },
            "Write the displaced beams as ." + ending + ", too");
    }
    verb.add_option("--series", options.series,
                    "Write the load steps or stages as a series for ParaView, too: this .pvd file, and "
                    "beside it a .vtu file for each step or stage");
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
    verb->callback([options, verb, &exit_code] {
        refuse_beside_stages(*verb, *options);
        exit_code = run(*verb, *options);
    });
}

}  // namespace fretwork::app
