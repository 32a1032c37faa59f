// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork tile: an outline becomes a project, tiled and painted.
#include "bar_checks.hpp"
#include "file_identity.hpp"
#include "interrupt.hpp"
#include "options/file_options.hpp"
#include "options/painting_options.hpp"
#include "options/tiling_options.hpp"
#include "output.hpp"
#include "verbs.hpp"
#include "verbs/tile_output.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file_lock.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <variant>

namespace fretwork::app {
namespace {

using library::Library;
using simulation::Project;

struct TileOptions {
    std::string outline;
    std::string part = "largest";
    std::optional<std::string> width;
    TilingText tiling;
    typed::PaintingText painting;
    std::string library;
    std::string setting;
    std::string layout;
    std::string out;
    std::string clearance;
    bool keep_mesh = false;
    bool json = false;
};

constexpr LengthOption kWidth{"--width", 10.0};

std::optional<double> wanted_width(const TileOptions& options) {
    if (!options.width) return std::nullopt;
    const double width = read_length(kWidth, *options.width);
    if (!(width > 0))
        throw base::InputError(kWidth.name, "", "'" + *options.width + "' is not a width, such as 400mm");
    return width;
}

outlines::OutlineFile read_outline(const TileOptions& options, std::optional<double> width) {
    outlines::OutlineFile file =
        outlines::take_parts(outlines::read_outline_file(options.outline), options.part);
    return width ? outlines::scaled_to_width(std::move(file), *width) : file;
}

/// True if --out is a project, which is tiled again. Devices and pipes, such as /dev/stdout, are not read.
bool is_tiled_again(const TileOptions& options) {
    return std::filesystem::exists(options.out) && !is_device(options.out);
}

/// The library that is named; else that of the project which is tiled again, if it has one.
std::optional<Library> open_library(const TileOptions& options) {
    if (!options.library.empty()) return Library::open(options.library);
    if (!is_tiled_again(options)) return std::nullopt;
    return simulation::open_project_library(options.out, simulation::read_project(options.out), "");
}

/// The setting that is named. Else that of the project that is tiled again, unless --library is given. Else
/// none: make_project() then takes the library's, or the setting "made".
std::optional<reduction::Setting> wanted_setting(const TileOptions& options, const Library* library) {
    if (!options.setting.empty()) return reduction::find_setting(options.setting);
    if (!options.library.empty() || !is_tiled_again(options)) return std::nullopt;
    return simulation::setting_of(simulation::read_project(options.out), library);
}

/// The library of a project is named relative to the project file.
void name_library(Project& project, const TileOptions& options, const Library* library) {
    project.library_path.clear();
    project.library_hash.clear();
    if (!library) return;
    project.library_path = simulation::library_path_from(options.out, library->path());
    project.library_hash = library->content_hash();
}

/// Throws InputError if an entry of a load case that stays selects nothing on the new tiles.
void check_what_stays(const Project& project, const TileOptions& options) {
    for (const simulation::LoadCase& load_case : project.load_cases) {
        try {
            simulation::check_selections(load_case, project.tessellation);
        } catch (const base::InputError& error) {
            throw base::InputError(options.out, "",
                                   std::string("its ") + error.what() +
                                       " on the new tiles; nothing is written: choose another --out");
        }
    }
}

bool picks_by_number(const simulation::LoadCase& load_case) {
    const auto is_by_number = [](const auto& entry) {
        return std::holds_alternative<simulation::NodesById>(entry.where);
    };
    const auto is_area_by_number = [](const simulation::LoadCase::AreaLoad& load) {
        const auto* nodes = std::get_if<simulation::Selection>(&load.where);
        return nodes == nullptr || std::holds_alternative<simulation::NodesById>(*nodes);  // null: tiles
    };
    return std::ranges::any_of(load_case.supports, is_by_number) ||
           std::ranges::any_of(load_case.prescribed, is_by_number) ||
           std::ranges::any_of(load_case.loads, is_by_number) ||
           std::ranges::any_of(load_case.area_loads, is_area_by_number);
}

/// Numbers of nodes and tiles mean other places on other tiles.
void warn_of_numbers(const Project& before, const Project& tiled) {
    if (before.tessellation.interface_nodes == tiled.tessellation.interface_nodes) return;
    const auto count = std::ranges::count_if(before.load_cases, picks_by_number);
    if (count == 0) return;
    warn(std::to_string(count) +
         " of the load cases kept select interface nodes or tiles by number, and these now lie elsewhere");
}

/// Numbers of tiles mean other places on other tiles.
void drop_tile_models(Project& before, const Project& tiled) {
    if (before.tile_models.empty()) return;
    if (before.tessellation.interface_nodes == tiled.tessellation.interface_nodes) return;
    before.tile_models.clear();
    warn("the tile models of single tiles are dropped, because the tiles are new");
}

/// Put the new tiles into the project that is there, or into a new one, and write it.
Project write(Project tiled, const TileOptions& options, const Library* library) {
    std::optional<base::FileLock> lock;
    Project project;
    if (is_tiled_again(options)) {
        lock.emplace(options.out);
        project = simulation::read_project(options.out);
        warn_of_numbers(project, tiled);
        drop_tile_models(project, tiled);
    }
    project.layout = std::move(tiled.layout);
    project.outline = std::move(tiled.outline);
    project.further_outlines = std::move(tiled.further_outlines);
    project.tessellation = std::move(tiled.tessellation);
    project.recipes = std::move(tiled.recipes);
    project.setting = std::move(tiled.setting);
    name_library(project, options, library);
    check_what_stays(project, options);
    simulation::write_project(project, options.out);
    return project;
}

/// Warns of the points of the outline that were left out.
void warn_of_points(const simulation::NewProject& made) {
    const std::size_t points = made.report.negligible_points;
    if (points == 0) return;
    warn(base::counted(points, "point") + " of the outline left out: within " +
         base::format_number(1e3 * tiling::kNegligibleShare * made.edge_length, 3) +
         " mm of the previous point");
}

/// Warns of the changes to the drawing, in one line.
void tell(const outlines::OutlineFile& file, const TileOptions& options) {
    if (file.remarks.empty()) return;
    warn(options.outline + ": " + base::join(file.remarks, "; "));
}

void print_json(const tiling::TessellationReport& report, const Project& project,
                const outlines::OutlineFile& file) {
    base::Json json = {{"outline", {{"size", outlines::size_text(file.parts)}, {"remarks", file.remarks}}}};
    json.update(tiling_json(report, project));
    print_document(json);
}

void print(const tiling::TessellationReport& report, const Project& project, const TileOptions& options) {
    print_tiling(report, project);
    if (options.library.empty() && !project.library_path.empty())
        std::printf("the project keeps its library: %s\n", base::printable(project.library_path).c_str());
    std::printf("setting: %s, joints: %s\n", reduction::setting_name(project.setting.value()).c_str(),
                std::string(reduction::joints_name(project.setting->joints)).c_str());
    std::printf("%s\n", options.out.c_str());
}

/// Options are checked before any file is read.
simulation::NewProjectOptions wanted_project(const TileOptions& options) {
    simulation::NewProjectOptions wanted{.outline_name = options.outline,
                                         .layout = options.layout,
                                         .painting = typed::read_painting(options.painting)};
    wanted.edge_length = wanted_edge_length(options.tiling);
    wanted.angle = wanted_angle(options.tiling);
    wanted.narrow = wanted_narrow(options.tiling);
    if (options.keep_mesh) wanted.tiles = simulation::TilesFrom::Mesh;
    return wanted;
}

simulation::NewProject make(const outlines::OutlineFile& file, const simulation::NewProjectOptions& wanted,
                            const Library* library) {
    try {
        return simulation::make_project(file.parts, wanted, library);
    } catch (const base::GeometryError&) {
        throw;  // an error of the outline
    } catch (const base::InputError& error) {
        throw with_option_name(error);
    }
}

void run(const TileOptions& options) {
    simulation::NewProjectOptions wanted = wanted_project(options);
    const std::optional<double> width = wanted_width(options);
    const std::optional<Library> opened = open_library(options);
    const Library* library = opened ? &*opened : nullptr;
    wanted.setting = wanted_setting(options, library);
    const outlines::OutlineFile file = read_outline(options, width);
    tell(file, options);
    // Ctrl-C asks to stop only here, where files may be half-written. Before and after, it ends the program.
    std::optional<LongWork> work(std::in_place);
    wanted.control = work->control();
    simulation::NewProject made = make(file, wanted, library);
    warn_of_points(made);
    const Project project = write(std::move(made.project), options, library);
    work.reset();
    warn_of_unkept_file(project, wanted.painting, made.painted);
    warn_of_close_bars(project, library, options.clearance);
    if (options.json) return print_json(made.report, project, file);
    std::printf("outline of %s%s\n", outlines::size_text(file.parts).c_str(),
                file.parts.size() > 1 ? (", " + std::to_string(file.parts.size()) + " parts").c_str() : "");
    print(made.report, project, options);
}

}  // namespace

void add_tile(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand("tile", "Cover an outline with tiles and paint them with patterns");
    const auto options = std::make_shared<TileOptions>();
    verb->add_option("outline", options->outline, "Outline: SVG, DXF, JSON, or a flat OBJ, PLY or OFF")
        ->required();
    verb->add_option("--part", options->part,
                     "Part of a drawing that has several: largest, all (each part then needs its own "
                     "supports), or a number; part 1 is the largest (default: largest)");
    CLI::Option* width =
        verb->add_option("--width", options->width,
                         "Scale the outline to this width, such as 400mm (default: the drawing's own)")
            ->type_name("LENGTH");
    add_tiling_options(*verb, options->tiling, "the setting's tile side");
    verb->add_flag("--keep-mesh", options->keep_mesh,
                   "Use the faces of a flat OBJ, PLY or OFF as tiles, unchanged")
        ->excludes("--edge-length")
        ->excludes("--angle")
        ->excludes(width);
    add_painting_options(*verb, options->painting);
    add_clearance_option(*verb, options->clearance);
    verb->add_option("--library", options->library,
                     "Library of the project (default: the library of an existing project at --out)");
    verb->add_option("--setting", options->setting,
                     "Setting with material, section and joints: paper (bars deform along their whole "
                     "centrelines), made (joints are stiff), or a setting file (default: the setting of an "
                     "existing project at --out; else of the library; else made)");
    verb->add_option("--layout", options->layout,
                     "Node layout: a name or a file (default: the library's, or paper7)");
    verb->add_option(
            "--out", options->out,
            "Project file to write; an existing project keeps its load cases, its library and its setting")
        ->required();
    verb->add_flag("--json", options->json, "Print JSON");
    declare_files(*verb, {input("outline"), input("--patterns"), input("--palette"), input("--library"),
                          input("--setting"), input("--layout"), update("--out", kProjectFile)});
    verb->footer(
        "Example: fretwork tile experiments/outlines/example_a.svg --patterns random:1 --palette "
        "0-1+1-6,0-5+5-6 "
        "--out project.json");
    verb->callback([options] { run(*options); });
}

}  // namespace fretwork::app
