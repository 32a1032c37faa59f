// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork design: paint a project so that its surface takes a wanted shape.
#include "design_output.hpp"
#include "interrupt.hpp"
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "other_project.hpp"
#include "typed/palette_text.hpp"
#include "typed/symmetry_text.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/design/design.hpp>
#include <fretwork/design/design_words.hpp>
#include <fretwork/design/target/target_file.hpp>
#include <fretwork/exports/designs/design_page.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

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
    std::string clearance;
    std::string out;
    std::string report;
    bool json = false;
    design::DesignOptions design;
};

using Flag = bool design::DesignOptions::*;
constexpr std::array<std::pair<std::string_view, Flag>, 4> kFree = {
    {{"factor", &design::DesignOptions::free_factor},
     {"prescribed", &design::DesignOptions::free_prescribed},
     {"width", &design::DesignOptions::free_width},
     {"thickness", &design::DesignOptions::free_thickness}}};

void read_free(const std::string& text, design::DesignOptions& options) {
    if (text.empty()) return;
    for (const std::string& word : base::split(text, ',')) {
        const auto entry = std::ranges::find(kFree, word, &std::pair<std::string_view, Flag>::first);
        if (entry == kFree.end())
            throw base::InputError("--free", "",
                                   "'" + word +
                                       "' is unknown: expected factor, prescribed, width, thickness, or "
                                       "several with commas");
        options.*(entry->second) = true;
    }
}

/// Errors of the target name the target's file; other errors name the project's file.
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

/// Calls `read` unless the text is empty; errors name the option.
template <class Read>
void read_as(const char* option, const std::string& text, const Read& read) {
    if (text.empty()) return;
    base::located(option, "", read);
}

void read_typed(DesignArguments& arguments, const simulation::Project& project) {
    design::DesignOptions& options = arguments.design;
    read_as("--case", options.load_case,
            [&] { (void)simulation::find_load_case(project, options.load_case); });
    read_as("--keep", arguments.keep,
            [&] { options.keep = tiling::parse_tiles(arguments.keep, project.tessellation); });
    read_as("--symmetry", arguments.symmetry,
            [&] { options.symmetry = typed::read_symmetry(arguments.symmetry); });
    if (!arguments.clearance.empty()) options.clearance = base::parse_length(arguments.clearance);
    read_free(arguments.free, options);
    if (options.load_case.empty() && project.load_cases.size() == 1)
        options.load_case = project.load_cases.front().name;
}

bool keeps_limits(const design::DesignReport& report, const design::DesignOptions& options) {
    return report.close_bars == 0 && report.keeps_mass(options) && report.keeps_utilization(options);
}

void write_design(const DesignArguments& arguments, const design::DesignReport& report,
                  const design::Target& target) {
    base::FileBatch files;
    files.add(arguments.out, simulation::project_text(report.project));
    if (!arguments.report.empty()) files.add(arguments.report, exports::design_html(report, target));
    files.commit();
}

ExitCode run(DesignArguments arguments) {
    LongWork work;
    const design::Target target = design::read_target(arguments.target);
    const simulation::Project project = simulation::read_checked_project(arguments.project);
    refuse_other_project(arguments.out, {project, arguments.project});
    design::DesignOptions& options = arguments.design;
    read_typed(arguments, project);
    std::optional<library::Library> library;
    if (!arguments.library.empty() || arguments.palette == "library" || !project.setting)
        library = simulation::open_project_library(arguments.project, project, arguments.library);
    const library::Library* given = library ? &*library : nullptr;
    options.palette =
        typed::read_palette({arguments.palette, options.seed, work.control()}, project.layout, given);
    if (options.max_utilization > 0.0 && !simulation::setting_of(project, given).strength)
        throw base::InputError("--max-utilization", "",
                               "needs a strength, and the project's setting has none");
    options.control = work.control();
    design::DesignReport report = run_design(arguments, project, given, target, options);
    simulation::move_library_path(report.project, arguments.project, arguments.out);
    write_design(arguments, report, target);
    const std::vector<design::DesignWarning> warnings = design::design_warnings(report, options);
    if (arguments.json) {
        print_design_json(report, warnings);
    } else {
        print_design(report);
    }
    warn_of_design(warnings);
    const bool is_ended =
        report.end != design::DesignEnd::Stopped && report.end != design::DesignEnd::Unreachable;
    return report.is_better() && keeps_limits(report, options) && is_ended ? ExitCode::Done
                                                                           : ExitCode::DidNotSucceed;
}

void add_task(CLI::App& verb, DesignArguments& arguments) {
    design::DesignOptions& options = arguments.design;
    verb.add_option("project", arguments.project, "Project file")->required();
    verb.add_option("--target", arguments.target,
                    "Target file: wanted displacements, positions or rotations of nodes, or a mesh on which "
                    "they are to lie")
        ->required();
    verb.add_option("--case", options.load_case,
                    "Load case for goals that name none (default: the only one of the project)")
        ->type_name("NAME");
    verb.add_option("--palette", arguments.palette,
                    "Patterns to choose from: ids joined by commas; library (all of the library); all (all "
                    "valid patterns of the layout); sample:N (N of the valid patterns, at random)")
        ->capture_default_str();
    verb.add_option(
            "--max-patterns", options.max_patterns,
            "Maximum number of different patterns, including those of tiles under --keep (default: no limit)")
        ->check(CLI::Range(1, 1'000'000));
    verb.add_option("--keep", arguments.keep, "Tiles that keep their patterns: 3,7-11")->type_name("TILES");
    verb.add_option("--free", arguments.free,
                    "What is searched besides the painting, joined by commas: factor (on the loads, not on "
                    "the weight), prescribed (the values of prescribed displacements), width, thickness (of "
                    "all bars, which must be rectangular; from 1/3 to 3 times the present value)")
        ->type_name("factor,prescribed,width,thickness");
}

void add_limits(CLI::App& verb, DesignArguments& arguments) {
    design::DesignOptions& options = arguments.design;
    verb.add_option("--symmetry", arguments.symmetry,
                    "Symmetry of the painting about the middle of the bounding box: mirror:x (left and right "
                    "are alike), mirror:y (top and bottom), turn:N (N equal sectors, from 2 to 12)")
        ->type_name("SYMMETRY");
    verb.add_option("--max-mass", options.max_mass, "Largest mass of all beams together, kg")
        ->check(above_zero_check());
    verb.add_option("--max-utilization", options.max_utilization,
                    "Largest utilization of a bar. It is checked with the full model, and the estimated "
                    "discretization error is added. The result is the best painting that passes this check")
        ->check(above_zero_check());
    verb.add_option("--clearance", arguments.clearance,
                    "Smallest gap between bars, such as 0.5mm. Patterns with a smaller gap are left out. The "
                    "result is the best painting without smaller gaps")
        ->check(length_check());
}

void add_effort(CLI::App& verb, DesignArguments& arguments) {
    design::DesignOptions& options = arguments.design;
    verb.add_option("--seconds", options.seconds,
                    "Limit of the wall time in seconds, checks included (default: no limit)")
        ->check(above_zero_check());
    verb.add_option(
            "--solutions", options.most_solutions,
            "Maximum number of nonlinear solutions of the search (default: 40, and more for fewer than 44 "
            "tiles). The solutions that fit the unknowns of --free to single patterns do not count")
        ->check(CLI::Range(1, 1'000'000));
    verb.add_option("--seed", options.seed, "Seed of all random choices")
        ->check(seed_check())
        ->capture_default_str();
    verb.add_option("--threads", options.threads, "Threads to use; 0: one for each processor")
        ->check(thread_check())
        ->capture_default_str();
}

void add_files(CLI::App& verb, DesignArguments& arguments) {
    verb.add_option("--library", arguments.library,
                    "Library with patterns and setting (default: the project's)");
    verb.add_option("--out", arguments.out, "Project file to write")->required();
    verb.add_option("--report", arguments.report,
                    "HTML page to write, with the bent surface over the target, errors, painting, course of "
                    "the search, and curvatures");
    verb.add_flag("--json", arguments.json, "Print JSON: errors, patterns, history, seconds, solutions");
}

}  // namespace

void add_design(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "design", "Search for a painting that gives the surface a wanted shape under its loads");
    const auto arguments = std::make_shared<DesignArguments>();
    add_task(*verb, *arguments);
    add_limits(*verb, *arguments);
    add_effort(*verb, *arguments);
    add_files(*verb, *arguments);
    declare_files(*verb, {input("project"), input("--target"), input("--palette"), input("--library"),
                          output("--out", kProjectFile), output("--report", kPageFile)});
    verb->footer(
        "Example: fretwork design project.json --case tip --target arc.json --palette sample:64 --out "
        "designed.json\n"
        "A target: {\"format\": \"fretwork/target/1\", \"goals\": [{\"select\": {\"side\": \"right\"}, "
        "\"displacement\": [null, null, \"0.05\"]}]}\n"
        "Ctrl-C ends the search and writes the best painting so far. Exit code 0: the painting, checked with "
        "all beams, is better than the best single pattern. 1: a painting is written, but it is not better, "
        "the search was stopped, the target is out of reach, or a limit is not kept.");
    verb->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace fretwork::app
