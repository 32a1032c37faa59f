// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork case: the load cases of a project.
#include "file_options.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/file_lock.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/combination.hpp>
#include <fretwork/simulation/conditions.hpp>
#include <fretwork/simulation/load_case_file.hpp>
#include <fretwork/simulation/project.hpp>
#include <fretwork/simulation/project_file.hpp>
#include <fretwork/simulation/surface.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace fretwork::app {
namespace {

using simulation::LoadCase;
using simulation::Project;

struct Options {
    std::string project;
    std::string file;
    bool replace = false;
    bool json = false;
};

/// Every selection of the load case must pick something on this project's tessellation, painted or not: so
/// the masses of the tiles are left out.
void check_on(const Project& project, const LoadCase& load_case) {
    (void)simulation::resolve(simulation::combined(load_case, project.load_cases),
                              simulation::make_surface(project, nullptr), {});
}

void add_to_project(const Options& options) {
    const base::FileLock lock(options.project);
    Project project = simulation::read_project(options.project);
    LoadCase load_case = simulation::read_load_case(options.file);
    check_on(project, load_case);
    const auto same = std::find_if(project.load_cases.begin(), project.load_cases.end(),
                                   [&](const LoadCase& other) { return other.name == load_case.name; });
    if (same != project.load_cases.end() && !options.replace) {
        throw base::InputError(
            options.file, "/name",
            "'" + load_case.name + "' is in the project already; --replace takes its place");
    }
    if (same != project.load_cases.end()) {
        *same = std::move(load_case);
    } else {
        project.load_cases.push_back(std::move(load_case));
    }
    simulation::write_project(project, options.project);
}

void list(const Options& options) {
    const Project project = simulation::read_project(options.project);
    base::Json json = base::Json::array();
    for (const LoadCase& load_case : project.load_cases) {
        json.push_back({{"name", load_case.name}, {"description", load_case.description}});
        if (!options.json)
            std::printf("%-20s %s\n", base::printable(load_case.name).c_str(),
                        base::printable(load_case.description).c_str());
    }
    if (options.json) std::fputs(base::json_text(json).c_str(), stdout);
}

}  // namespace

void add_case(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand("case", "Add a load case to a project, or list those it has");
    verb->require_subcommand(1);
    const auto options = std::make_shared<Options>();

    CLI::App* add = verb->add_subcommand("add", "Add a load case from its file");
    add->add_option("project", options->project, "Project file")->required();
    add->add_option("file", options->file, "Load case file (JSON)")->required();
    add->add_flag("--replace", options->replace, "Take the place of a load case of the same name");
    declare_files(*add, {update("project", kProjectFile), input("file")});
    add->footer("Example: fretwork case add project.json experiments/cases/cantilever.json");
    add->callback([options] { add_to_project(*options); });

    CLI::App* show = verb->add_subcommand("list", "List the load cases of a project");
    show->add_option("project", options->project, "Project file")->required();
    show->add_flag("--json", options->json, "Print JSON");
    declare_files(*show, {input("project")});
    show->footer("Example: fretwork case list project.json");
    show->callback([options] { list(*options); });
    verb->footer("Example: fretwork case add project.json experiments/cases/cantilever.json");
}

}  // namespace fretwork::app
