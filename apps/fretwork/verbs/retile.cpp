// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork retile: other tiles for the outline of a project.
#include "bar_checks.hpp"
#include "interrupt.hpp"
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "options/painting_options.hpp"
#include "options/tiling_options.hpp"
#include "other_project.hpp"
#include "output.hpp"
#include "verbs.hpp"
#include "verbs/tile_output.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/project/retiling.hpp>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::app {
namespace {

using simulation::DroppedEntries;
using simulation::Project;
using simulation::RetiledProject;
using simulation::RetilingOptions;

struct RetileOptions {
    std::string project;
    TilingText tiling;
    std::string layout;
    typed::PaintingText painting;
    std::string library;
    std::string clearance;
    std::string out;
    bool json = false;
};

/// Options are checked before any tile is made.
RetilingOptions wanted_tiles(const RetileOptions& options) {
    RetilingOptions wanted{.edge_length = wanted_edge_length(options.tiling),
                           .angle = wanted_angle(options.tiling),
                           .narrow = wanted_narrow(options.tiling),
                           .painting = typed::read_painting(options.painting)};
    if (!options.layout.empty())
        wanted.layout =
            base::located("--layout", "", [&] { return pattern::find_node_layout(options.layout); });
    return wanted;
}

/// With another layout, the project's library is not opened: it has no such patterns.
std::optional<library::Library> painting_library(const RetileOptions& options, const Project& project,
                                                 const RetilingOptions& wanted) {
    const bool has_own =
        wanted.layout.value_or(project.layout) == project.layout && !options.painting.patterns.empty();
    if (options.library.empty() && !has_own) return std::nullopt;
    return simulation::open_project_library(options.project, project, options.library);
}

/// Errors of the outline, of load cases and of recipes name the project, those of the painting their options.
RetiledProject retiled_project(const RetileOptions& options, const Project& project,
                               const RetilingOptions& wanted, const library::Library* library) {
    try {
        return simulation::retile(project, wanted, library);
    } catch (const base::GeometryError& error) {
        throw base::within(options.project, "", error);
    } catch (const base::InputError& error) {
        const auto& where = error.data().where;
        const auto is_about = [&](const char* part) {
            return !where.empty() && where.front().source.starts_with(part);
        };
        throw is_about("load case") || is_about("recipe ") ? base::within(options.project, "", error)
                                                           : with_option_name(error);
    }
}

void warn_of_dropped(const DroppedEntries& dropped) {
    std::vector<std::string> parts;
    const auto add = [&](int count, const char* noun) {
        if (count > 0) parts.push_back(base::counted(static_cast<std::size_t>(count), noun));
    };
    add(dropped.supports, "support");
    add(dropped.loads, "load");
    add(dropped.prescribed, "prescribed displacement");
    if (parts.empty()) return;
    warn("left out of the load cases: " + base::join(parts, ", ") +
         "; they name nodes or tiles by number, which are others now. Those on sides, in boxes, in circles "
         "and at places "
         "stay");
}

/// With another layout, patterns have other nodes.
void warn_of_bare_tiles(const RetiledProject& made, const Project& before) {
    if (!tiling::used_patterns(made.project.tessellation).empty()) return;
    if (tiling::used_patterns(before.tessellation).empty()) return;
    warn("no tile is painted: patterns of the layout " + before.layout.name() + " are none of " +
         made.project.layout.name() + "; --patterns paints");
}

base::Json retiling_json(const RetiledProject& made) {
    base::Json json = tiling_json(made.report, made.project);
    json["unpainted_tiles"] = unpainted_count(made.project.tessellation);
    json["dropped"] = {{"supports", made.dropped.supports},
                       {"loads", made.dropped.loads},
                       {"prescribed", made.dropped.prescribed}};
    return json;
}

void run(const RetileOptions& options) {
    RetilingOptions wanted = wanted_tiles(options);
    const Project project = simulation::read_checked_project(options.project);
    refuse_other_project(options.out, {project, options.project});
    const auto library = painting_library(options, project, wanted);
    const library::Library* given = library ? &*library : nullptr;
    LongWork work;
    wanted.control = work.control();
    RetiledProject made = retiled_project(options, project, wanted, given);
    simulation::move_library_path(made.project, options.project, options.out);
    simulation::write_project(made.project, options.out);
    warn_of_dropped(made.dropped);
    warn_of_bare_tiles(made, project);
    warn_of_unkept_file(made.project, wanted.painting, made.painted);
    warn_of_close_bars(made.project, given, options.clearance);
    if (options.json) return print_document(retiling_json(made));
    print_tiling(made.report, made.project);
    std::printf("%s\n", base::printable(options.out).c_str());
}

/// Without one of these options, the new tiles would be the old ones.
void require_change(const CLI::App& verb) {
    for (const char* option : {"--edge-length", "--angle", "--narrow", "--layout"})
        if (verb.count(option) > 0) return;
    throw base::InputError(
        "retile", "", "needs --edge-length, --angle, --narrow or --layout: what is to be other than now?");
}

}  // namespace

void add_retile(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand("retile",
                                        "Cover the outline of a project with other tiles, and write a new "
                                        "project. Patterns, supports and loads stay at their positions");
    const auto options = std::make_shared<RetileOptions>();
    verb->add_option("project", options->project, "Project file")->required();
    add_tiling_options(*verb, options->tiling, "that of the present tiles");
    verb->add_option(
        "--layout", options->layout,
        "Node layout of the new tiles: a name or a file (default: the project's). With another layout, the "
        "tiles have no patterns unless --patterns gives them, and the new project has no library");
    add_painting_options(*verb, options->painting);
    add_clearance_option(*verb, options->clearance);
    verb->add_option("--library", options->library,
                     "Library with patterns and properties for --patterns (default: the project's)");
    verb->add_option("--out", options->out, "Project file to write")->required();
    verb->add_flag("--json", options->json,
                   "Print JSON: measures of the tiles, number of unpainted tiles, and number of dropped "
                   "entries of load cases");
    declare_files(*verb, {input("project"), input("--layout"), input("--patterns"), input("--palette"),
                          input("--library"), output("--out", kProjectFile)});
    verb->footer(
        "Example: fretwork retile project.json --edge-length 15mm --out finer.json\n"
        "         fretwork retile project.json --layout paper8 --patterns 0-1+1-7 --out other.json\n"
        "Without --patterns, each new tile takes the pattern of the old tile with the nearest middle. Tiles "
        "that were painted by a field, an image, colours or at random are painted in the same way again. "
        "Supports and loads on interface nodes by number are left out: their nodes lie elsewhere.");
    verb->callback([options, verb] {
        require_change(*verb);
        if (verb->count("--patterns") == 0) refuse_given(*verb, {"--library"}, "is for --patterns");
        run(*options);
    });
}

}  // namespace fretwork::app
