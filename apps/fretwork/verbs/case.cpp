// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork case: the load cases of a project.
#include "options/file_options.hpp"
#include "output.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file_lock.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/load_cases/load_case_text.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/surface.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace fretwork::app {
namespace {

using simulation::LoadCase;
using simulation::Project;

struct CaseOptions {
    std::string project;
    std::string file;
    std::string name;
    std::string new_name;
    bool replace = false;
    bool json = false;
};

/// Throws unless every selection of the load case picks something on this project's tessellation. Tiles need
/// not be painted, so their masses are left out. Errors name the file that is to blame.
void check_on(const Project& project, const LoadCase& load_case, const CaseOptions& options) {
    const simulation::Surface surface =
        base::located(options.project, "", [&] { return simulation::make_surface(project, nullptr); });
    base::located(options.file, "", [&] {
        (void)simulation::resolve(simulation::combined(load_case, project.load_cases), surface, {});
    });
}

LoadCase& case_of(Project& project, const CaseOptions& options) {
    return *base::located(options.project, "", [&] {
        return &base::find_named(options.name, project.load_cases, &LoadCase::name, "load case");
    });
}

/// Prints what each entry selects, for people; warnings go to standard error.
void tell(const LoadCase& load_case, const Project& project, const CaseOptions& options) {
    if (!options.json) {
        std::printf("%s\n", base::printable(load_case.name).c_str());
        for (const std::string& line : simulation::entry_texts(load_case, project.tessellation))
            std::printf("  %s\n", base::printable(line).c_str());
    }
    const auto doubts = simulation::warnings_about(load_case, simulation::make_surface(project, nullptr));
    if (!doubts.empty()) warn(load_case.name + ": is that meant? " + base::join(doubts, "; "));
}

void add_to_project(const CaseOptions& options) {
    const base::FileLock lock(options.project);
    Project project = simulation::read_project(options.project);
    const LoadCase load_case = simulation::read_load_case(options.file);
    check_on(project, load_case, options);
    const auto same = std::ranges::find(project.load_cases, load_case.name, &LoadCase::name);
    if (same != project.load_cases.end() && !options.replace) {
        throw base::InputError(
            options.file, "/name",
            "'" + load_case.name + "' is in the project already; --replace takes its place");
    }
    if (same != project.load_cases.end()) {
        *same = load_case;
    } else {
        project.load_cases.push_back(load_case);
    }
    // A project with a combination of combinations could not be read again.
    base::located(options.project, "", [&] { simulation::check_combinations(project.load_cases); });
    simulation::write_project(project, options.project);
    tell(load_case, project, options);
}

/// Throws if another load case combines this one.
void check_not_combined(const Project& project, const std::string& name, const std::string& file) {
    for (const LoadCase& other : project.load_cases) {
        if (std::ranges::find(other.combines, name, &LoadCase::Share::load_case) != other.combines.end())
            throw base::InputError(
                file, "", "load case '" + other.name + "' combines '" + name + "': remove that one first");
    }
}

void remove_from_project(const CaseOptions& options) {
    const base::FileLock lock(options.project);
    Project project = simulation::read_project(options.project);
    const LoadCase* removed = &case_of(project, options);
    check_not_combined(project, removed->name, options.project);
    project.load_cases.erase(project.load_cases.begin() + (removed - project.load_cases.data()));
    simulation::write_project(project, options.project);
}

/// Combinations get the new name, too.
void rename_in_project(const CaseOptions& options) {
    const base::FileLock lock(options.project);
    Project project = simulation::read_project(options.project);
    if (options.new_name.empty()) throw base::InputError("new_name", "", "is empty, where a name is needed");
    const auto taken = std::ranges::find(project.load_cases, options.new_name, &LoadCase::name);
    if (taken != project.load_cases.end() && options.new_name != options.name)
        throw base::InputError(options.project, "", "has a load case '" + options.new_name + "' already");
    case_of(project, options).name = options.new_name;
    for (LoadCase& load_case : project.load_cases) {
        for (LoadCase::Share& share : load_case.combines)
            if (share.load_case == options.name) share.load_case = options.new_name;
    }
    simulation::write_project(project, options.project);
}

void show(const CaseOptions& options) {
    Project project = simulation::read_project(options.project);
    const LoadCase& load_case = case_of(project, options);
    if (options.json) std::fputs(simulation::load_case_text(load_case).c_str(), stdout);
    tell(load_case, project, options);
}

void list(const CaseOptions& options) {
    const Project project = simulation::read_project(options.project);
    base::Json json = base::Json::array();
    for (const LoadCase& load_case : project.load_cases) {
        json.push_back({{"name", load_case.name}, {"description", load_case.description}});
        if (!options.json)
            std::printf("%-20s %s\n", base::printable(load_case.name).c_str(),
                        base::printable(load_case.description).c_str());
    }
    if (options.json) print_document(json);
}

}  // namespace

void add_case(CLI::App& app, ExitCode&) {
    CLI::App* verb =
        app.add_subcommand("case", "Add load cases to a project; list, show, remove and rename them");
    verb->require_subcommand(1);
    const auto options = std::make_shared<CaseOptions>();

    CLI::App* add = verb->add_subcommand("add", "Add a load case from its file");
    add->add_option("project", options->project, "Project file")->required();
    add->add_option("file", options->file, "Load case file (JSON)")->required();
    add->add_flag("--replace", options->replace, "Replace a load case of the same name");
    declare_files(*add, {update("project", kProjectFile), input("file")});
    add->footer("Example: fretwork case add project.json experiments/cases/cantilever.json");
    add->callback([options] { add_to_project(*options); });

    CLI::App* listing = verb->add_subcommand("list", "List the load cases of a project");
    listing->add_option("project", options->project, "Project file")->required();
    listing->add_flag("--json", options->json, "Print JSON");
    declare_files(*listing, {input("project")});
    listing->footer("Example: fretwork case list project.json");
    listing->callback([options] { list(*options); });

    CLI::App* showing =
        verb->add_subcommand("show", "Show a load case, and how many nodes each of its entries selects");
    showing->add_option("project", options->project, "Project file")->required();
    showing->add_option("name", options->name, "Load case of the project")->required();
    showing->add_flag("--json", options->json, "Print the load case as its JSON file");
    declare_files(*showing, {input("project")});
    showing->footer("Example: fretwork case show project.json cantilever");
    showing->callback([options] { show(*options); });

    CLI::App* removal = verb->add_subcommand("remove", "Remove a load case from a project");
    removal->add_option("project", options->project, "Project file")->required();
    removal->add_option("name", options->name, "Load case of the project")->required();
    declare_files(*removal, {update("project", kProjectFile)});
    removal->footer("Example: fretwork case remove project.json cantilever");
    removal->callback([options] { remove_from_project(*options); });

    CLI::App* renaming =
        verb->add_subcommand("rename", "Rename a load case, also in the load cases that combine it");
    renaming->add_option("project", options->project, "Project file")->required();
    renaming->add_option("name", options->name, "Load case of the project")->required();
    renaming->add_option("new_name", options->new_name, "Its new name")->required();
    declare_files(*renaming, {update("project", kProjectFile)});
    renaming->footer("Example: fretwork case rename project.json cantilever tip");
    renaming->callback([options] { rename_in_project(*options); });
    verb->footer("Example: fretwork case add project.json experiments/cases/cantilever.json");
}

}  // namespace fretwork::app
