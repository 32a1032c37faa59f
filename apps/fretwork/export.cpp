// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork export: a project, and what was computed of it, as a drawing or a file for other programs.
#include "file_options.hpp"
#include "ignored_options.hpp"
#include "interrupt.hpp"
#include "surface_result.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/simulation/project_library.hpp>
#include <fretwork/simulation/result_subject.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

namespace fretwork::app {
namespace {

struct Options {
    std::string project;
    std::vector<std::string> to;
    std::string load_case;
    std::vector<std::string> results;
    std::string library;
    double scale = 1.0;
};

mechanics::Result read_own_result(const std::string& file, const simulation::Surface& surface) {
    mechanics::Result result = read_surface_result(file);
    if (!result.subject) return result;
    const std::string difference = simulation::subject_difference(*result.subject, surface);
    if (!difference.empty())
        throw base::InputError(file, "", "is no result of this project: they differ in " + difference);
    return result;
}

/// Options that only drawings look at.
void refuse_ignored_options(const CLI::App& verb, const Options& options) {
    const bool has_drawing = std::ranges::any_of(
        options.to, [](const std::string& path) { return exports::find_writer(path).is_drawing; });
    if (has_drawing) return;
    refuse_given(verb, {"--case", "--scale"}, "is for drawings, and no --to names one (.svg)");
}

/// The supports and loads that are drawn must be those of the results.
void check_load_case(const simulation::LoadCase& load_case, const Options& options,
                     const exports::Scene& scene) {
    const auto drawn = simulation::result_subject(scene.surface, load_case, {});
    for (std::size_t i = 0; i < scene.results.size(); ++i) {
        const auto& subject = scene.results[i].result.subject;
        const std::string difference = subject ? simulation::subject_difference(*subject, drawn) : "";
        if (!difference.empty())
            throw base::InputError(options.results[i], "",
                                   "is no result of the load case '" + load_case.name +
                                       "' of --case: they differ in " + difference);
    }
}

exports::Scene make_scene(const Options& options, const base::Control& control) {
    const simulation::Project project = simulation::read_checked_project(options.project);
    const auto library = simulation::open_project_library(options.project, project, options.library);
    exports::Scene scene{simulation::make_surface(project, library ? &*library : nullptr)};
    for (const std::string& file : options.results) {
        control.check();
        scene.results.push_back(
            {std::filesystem::path(file).stem().string(), read_own_result(file, scene.surface)});
    }
    if (!options.load_case.empty()) {
        const simulation::LoadCase& load_case = simulation::find_load_case(project, options.load_case);
        check_load_case(load_case, options, scene);
        scene.conditions = simulation::resolve(load_case, scene.surface);
    }
    scene.displacement_scale = options.scale;
    return scene;
}

void run(const Options& options) {
    for (const std::string& path : options.to) (void)exports::find_writer(path);
    if (!std::isfinite(options.scale)) throw base::InputError("--scale", "", "is not a finite number");
    LongWork work;
    const base::Control control = work.control();
    const exports::Scene scene = make_scene(options, control);
    base::FileBatch files;
    for (const std::string& path : options.to) {
        control.check();
        files.add(path, exports::find_writer(path).text(scene));
    }
    control.check();
    files.commit();
}

std::string kinds_help() {
    std::string text = "File to write; its ending says what kind (repeatable):";
    for (const exports::WriterRow& writer : exports::writer_catalogue()) {
        text += "\n  " + std::string(writer.ending) + ": " + std::string(writer.description);
    }
    return text;
}

}  // namespace

void add_export(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand(
        "export", "Write a project, and results of it, as drawings and files for other programs");
    const auto options = std::make_shared<Options>();
    verb->add_option("project", options->project, "Project file")->required();
    verb->add_option("--to", options->to, kinds_help())->required()->allow_extra_args(false);
    verb->add_option("--case", options->load_case, "Load case whose supports and loads are drawn");
    verb->add_option("--result", options->results,
                     "Result file of this project (repeatable: drawn over each other)")
        ->allow_extra_args(false);
    verb->add_option("--library", options->library, "Library with the setting (default: the project's)");
    verb->add_option("--scale", options->scale, "Factor on the displacements in drawings")
        ->capture_default_str();
    declare_files(*verb,
                  {input("project"), output("--to", kExportFile), input("--result"), input("--library")});
    verb->footer(
        "Example: fretwork export project.json --result full.json --result condensed.json --to deformed.svg");
    verb->callback([options, verb] {
        refuse_ignored_options(*verb, *options);
        run(*options);
    });
}

}  // namespace fretwork::app
