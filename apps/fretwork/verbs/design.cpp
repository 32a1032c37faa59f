// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork design: paint a project so that its surface takes a wanted shape.
#include "interrupt.hpp"
#include "options/file_options.hpp"
#include "typed/palette_text.hpp"
#include "typed/symmetry_text.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/design/design.hpp>
#include <fretwork/design/target/target_file.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <cstdio>
#include <memory>
#include <optional>

namespace fretwork::app {
namespace {

struct DesignArguments {
    std::string project;
    std::string target;
    std::string palette = "sample:64";
    std::string keep;
    std::string free;
    std::string symmetry;
    std::string library;
    std::string out;
    bool json = false;
    design::DesignOptions design;
};

void read_free(const std::string& text, design::DesignOptions& options) {
    if (text.empty()) return;
    for (const std::string& word : base::split(text, ',')) {
        if (word == "factor") {
            options.free_factor = true;
        } else if (word == "prescribed") {
            options.free_prescribed = true;
        } else {
            throw base::InputError("--free", "",
                                   "'" + word + "' is unknown: expected factor, prescribed, or both");
        }
    }
}

/// Errors of a target name its file, those of the project its own.
design::DesignReport run_design(const DesignArguments& arguments, const simulation::Project& project,
                                const library::Library* library, const design::Target& target,
                                const design::DesignOptions& options) {
    try {
        return design::design(project, library, target, options);
    } catch (const base::InputError& error) {
        const auto& where = error.data().where;
        const bool is_target = !where.empty() && where.front().place.starts_with("/goals");
        throw base::within(is_target ? arguments.target : arguments.project, "", error);
    } catch (const base::NumericalError& error) {
        throw base::within(arguments.project, "", error);
    }
}

base::Json error_json(const std::optional<design::TargetError>& error, double design::TargetError::*which) {
    return error ? base::Json((*error).*which) : base::Json(nullptr);
}

base::Json report_json(const design::DesignReport& report) {
    using design::TargetError;
    base::Json history = base::Json::array();
    for (const design::DesignProgress& own : report.history)
        history.push_back({{"solutions", own.solutions}, {"seconds", own.seconds}, {"misfit", own.misfit}});
    return {{"error_mean", error_json(report.error, &TargetError::mean)},
            {"error_largest", error_json(report.error, &TargetError::largest)},
            {"error_best_uniform", error_json(report.best_uniform, &TargetError::mean)},
            {"best_uniform_pattern", report.best_uniform_pattern},
            {"uniform_tried", report.uniform_tried},
            {"error_relaxed", nullptr},
            {"bound", nullptr},
            {"stable", report.error ? base::Json(report.error->is_stable) : base::Json(nullptr)},
            {"model_error", report.model_error},
            {"largest_utilization",
             report.largest_utilization ? base::Json(*report.largest_utilization) : base::Json(nullptr)},
            {"load_cases", report.load_cases},
            {"factors", report.factors},
            {"wanted_of_softest", report.wanted_of_softest},
            {"wanted_of_stiffest", report.wanted_of_stiffest},
            {"slides", report.slides},
            {"end", design::design_end_name(report.end)},
            {"starts", report.starts},
            {"history", history},
            {"patterns", report.patterns},
            {"seconds", report.seconds},
            {"solutions", report.solutions},
            {"full_solutions", report.full_solutions},
            {"seed", report.seed}};
}

const char* end_text(design::DesignEnd end) {
    switch (end) {
        case design::DesignEnd::NoSwapImproves:
            return "the search found no further swap that improves it";
        case design::DesignEnd::SolutionsSpent:
            return "the solutions were spent";
        case design::DesignEnd::TimeSpent:
            return "the time was spent";
        default:
            return "the search was stopped: this is the best painting so far";
    }
}

void print(const design::DesignReport& report) {
    if (report.error) {
        std::printf(
            "mean error %.3g %%, largest %.3g %% of the largest displacement wanted (checked with all "
            "beams)%s\n",
            100.0 * report.error->mean, 100.0 * report.error->largest,
            report.error->is_stable ? "" : "; NOT STABLE");
    } else {
        std::puts("distance to the target: not checked with all beams");
    }
    if (report.best_uniform)
        std::printf("best single pattern of %zu: %.3g %% (%s)\n", report.uniform_tried,
                    100.0 * report.best_uniform->mean, report.best_uniform_pattern.c_str());
    for (std::size_t c = 0; c < report.factors.size(); ++c) {
        if (report.factors[c] != 1.0)
            std::printf("load case '%s': its loads times %.4g\n", report.load_cases[c].c_str(),
                        report.factors[c]);
    }
    if (report.largest_utilization)
        std::printf("largest utilization: %.3g %%\n", 100.0 * *report.largest_utilization);
    if (report.slides) std::puts("nodes slide along the target's surface: only distances to it count");
    std::printf("%zu patterns, %d nonlinear solutions and %d of all beams, %.2g s; %s\n",
                report.patterns.size(), report.solutions, report.full_solutions, report.seconds,
                end_text(report.end));
}

/// Says what keeps the target out of reach, where that is known.
void warn(const design::DesignReport& report, const design::DesignOptions& options) {
    const char* hint = options.free_factor ? "" : " (--free factor searches one)";
    if (report.wanted_of_softest > 2.0)
        std::fprintf(stderr,
                     "fretwork: the target asks for %.3g times the displacement of the softest single "
                     "pattern tried: the load is too small for it%s\n",
                     report.wanted_of_softest, hint);
    if (report.wanted_of_stiffest > 0.0 && report.wanted_of_stiffest < 0.5)
        std::fprintf(stderr,
                     "fretwork: the target asks for %.3g times the displacement of the stiffest single "
                     "pattern tried: the load is too large for it%s\n",
                     report.wanted_of_stiffest, hint);
    if (options.max_utilization > 0.0 && report.largest_utilization.value_or(0.0) > options.max_utilization)
        std::fprintf(stderr, "fretwork: no painting that was checked keeps the utilization below %.3g\n",
                     options.max_utilization);
}

ExitCode run(DesignArguments arguments) {
    LongWork work;
    const design::Target target = design::read_target(arguments.target);
    const simulation::Project project = simulation::read_checked_project(arguments.project);
    design::DesignOptions& options = arguments.design;
    std::optional<library::Library> library;
    if (!arguments.library.empty() || arguments.palette == "library" || !project.setting)
        library = simulation::open_project_library(arguments.project, project, arguments.library);
    const library::Library* given = library ? &*library : nullptr;
    options.palette =
        typed::read_palette({arguments.palette, options.seed, work.control()}, project.layout, given);
    if (!arguments.keep.empty()) {
        try {
            options.keep = tiling::parse_tiles(arguments.keep, project.tessellation);
        } catch (const base::InputError& error) {
            throw base::within("--keep", "", error);
        }
    }
    read_free(arguments.free, options);
    if (!arguments.symmetry.empty()) {
        try {
            options.symmetry = typed::read_symmetry(arguments.symmetry);
        } catch (const base::InputError& error) {
            throw base::within("--symmetry", "", error);
        }
    }
    if (options.max_utilization > 0.0 && !simulation::setting_of(project, given).strength)
        throw base::InputError("--max-utilization", "",
                               "needs a strength, and the project's setting has none");
    if (options.load_case.empty() && project.load_cases.size() == 1)
        options.load_case = project.load_cases.front().name;
    options.control = work.control();
    const design::DesignReport report = run_design(arguments, project, given, target, options);
    simulation::write_project(report.project, arguments.out);
    if (arguments.json) {
        std::fputs(base::json_text(report_json(report)).c_str(), stdout);
    } else {
        print(report);
    }
    warn(report, options);
    const bool is_held =
        options.max_utilization <= 0.0 || report.largest_utilization.value_or(0.0) <= options.max_utilization;
    return report.is_better() && is_held && report.end != design::DesignEnd::Stopped
               ? ExitCode::Done
               : ExitCode::DidNotSucceed;
}

}  // namespace

void add_design(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "design", "Paint the tiles of a project so that its surface takes a wanted shape under its load");
    const auto arguments = std::make_shared<DesignArguments>();
    design::DesignOptions& options = arguments->design;
    verb->add_option("project", arguments->project, "Project file")->required();
    verb->add_option("--target", arguments->target, "Target file with the wanted positions of nodes")
        ->required();
    verb->add_option("--case", options.load_case,
                     "Load case for goals that name none (default: the only one)")
        ->type_name("NAME");
    verb->add_option("--palette", arguments->palette,
                     "Patterns to choose from: ids joined by commas, library, all (valid patterns), or "
                     "sample:N of these")
        ->capture_default_str();
    verb->add_option("--max-patterns", options.max_patterns,
                     "Most different patterns, those of kept tiles included (default: any number)")
        ->check(CLI::Range(1, 1'000'000));
    verb->add_option("--keep", arguments->keep, "Tiles that keep their patterns: 3,7-11")->type_name("TILES");
    verb->add_option("--free", arguments->free,
                     "Unknowns besides the painting: factor (on the loads, not the weight), prescribed (the "
                     "values of prescribed displacements), or both joined by a comma")
        ->type_name("factor,prescribed");
    verb->add_option("--symmetry", arguments->symmetry,
                     "Symmetry of the painting about the middle: mirror:x (left and right), mirror:y, turn:N")
        ->type_name("SYMMETRY");
    verb->add_option("--max-mass", options.max_mass, "Most mass of all beams, kg");
    verb->add_option(
        "--max-utilization", options.max_utilization,
        "Largest utilization, checked with all beams; the result is the best checked painting that keeps it");
    verb->add_option("--seconds", options.seconds,
                     "Wall time, checks included (default: until no swap improves)")
        ->check(CLI::Range(0.0, 1e9));
    verb->add_option("--solutions", options.most_solutions, "Most nonlinear solutions of the search")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    verb->add_option("--seed", options.seed, "Seed of all random choices")
        ->check(seed_check())
        ->capture_default_str();
    verb->add_option("--threads", options.threads, "Threads to use; 0: one for each processor")
        ->check(thread_check())
        ->capture_default_str();
    verb->add_option("--library", arguments->library,
                     "Library with patterns and setting (default: the project's)");
    verb->add_option("--out", arguments->out, "Project file to write")->required();
    verb->add_flag("--json", arguments->json, "Print JSON: errors, patterns, history, seconds, solutions");
    declare_files(*verb, {input("project"), input("--target"), input("--palette"), input("--library"),
                          output("--out", kProjectFile)});
    verb->footer(
        "Example: fretwork design project.json --case tip --target arc.json --palette sample:64 --out "
        "designed.json\n"
        "A target: {\"format\": \"fretwork/target/1\", \"goals\": [{\"select\": {\"side\": \"right\"}, "
        "\"displacement\": [null, "
        "null, \"0.05\"]}]}\n"
        "Ctrl-C keeps the best painting so far. Exit 0: better than the best single pattern, checked with "
        "all beams; 1: "
        "written, but not better, stopped, or beyond --max-utilization.");
    verb->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace fretwork::app
