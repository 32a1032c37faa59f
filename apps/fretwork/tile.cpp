// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork tile: an outline becomes a project, tiled and painted.
#include "file_options.hpp"
#include "verbs.hpp"

#include <fretwork/base/detail/json_text.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/reduction/setting.hpp>
#include <fretwork/simulation/project.hpp>
#include <fretwork/simulation/project_file.hpp>
#include <fretwork/tiling/painting.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace fretwork::app {
namespace {

using library::Library;
using simulation::Project;
using tiling::Tessellation;

/// What a person asks for.
struct Wishes {
    std::string outline;
    std::string edge_length;
    std::string patterns;
    std::string palette;
    std::string library;
    std::string layout;
    std::string out;
    bool json = false;
};

std::optional<Library> open_library(const Wishes& wishes) {
    if (wishes.library.empty()) return std::nullopt;
    return Library::open(wishes.library);
}

pattern::NodeLayout chosen_layout(const Wishes& wishes, const Library* library) {
    if (!library) return pattern::find_node_layout(wishes.layout.empty() ? "paper7" : wishes.layout);
    if (!wishes.layout.empty()) library->check_layout(pattern::find_node_layout(wishes.layout));
    return library->layout();
}

double chosen_edge_length(const Wishes& wishes, const Library* library) {
    if (!wishes.edge_length.empty()) return base::parse_length(wishes.edge_length);
    return library ? library->setting().tile_side : reduction::paper_setting().tile_side;
}

/// A palette whose complaints name the option that it came from.
std::vector<std::string> palette_of(const std::string& option, const pattern::NodeLayout& layout,
                                    const std::vector<std::string>& ids) {
    try {
        return tiling::make_palette(layout, ids);
    } catch (const base::InputError& error) {
        throw base::InputError(option, "", error.what());
    }
}

/// The patterns that a random painting chooses from: those that are named, else those that the library has
/// calibrated.
std::vector<std::string> chosen_palette(const Wishes& wishes, const pattern::NodeLayout& layout,
                                        const Library* library) {
    std::vector<std::string> palette;
    if (std::filesystem::path(wishes.palette).extension() == ".json")
        return tiling::read_painting(wishes.palette, layout).patterns;
    if (!wishes.palette.empty()) return palette_of("--palette", layout, base::split(wishes.palette, ','));
    if (!library)
        throw base::InputError(
            "--patterns", wishes.patterns,
            "a painting by chance needs patterns to choose from: give --palette or --library");
    for (const library::PatternEntry& entry : library->patterns()) {
        if (library->best_fit(entry.id)) palette.push_back(entry.id);
    }
    if (palette.empty())
        throw base::InputError(wishes.library, "", "has no calibrated pattern; name patterns with --palette");
    return palette;
}

std::uint64_t parse_seed(std::string_view text) {
    if (const auto seed = base::read_number<std::uint64_t>(text)) return *seed;
    throw base::InputError("--patterns", "", "'" + std::string(text) + "' is no seed; random:1 has one");
}

/// Paint as `--patterns` says: random:SEED, a painting file, or the id of one pattern.
void paint(Tessellation& tessellation, const Wishes& wishes, const pattern::NodeLayout& layout,
           const Library* library) {
    constexpr std::string_view kRandom = "random:";
    if (wishes.patterns.empty()) return;
    if (wishes.patterns.starts_with(kRandom)) {
        const auto palette = chosen_palette(wishes, layout, library);
        const auto seed = parse_seed(std::string_view(wishes.patterns).substr(kRandom.size()));
        return tiling::paint_randomly(tessellation, palette, seed);
    }
    if (std::filesystem::path(wishes.patterns).extension() != ".json") {
        const auto palette = palette_of("--patterns", layout, {wishes.patterns});
        return tiling::paint_uniformly(tessellation, palette.front());
    }
    try {
        tiling::paint(tessellation, tiling::read_painting(wishes.patterns, layout));
    } catch (const base::InputError& error) {
        const std::string message = error.what();
        if (message.starts_with(wishes.patterns)) throw;
        throw base::InputError(wishes.patterns, "/tiles", message);
    }
}

/// The library of a project is named relative to the project file.
void name_library(Project& project, const Wishes& wishes, const Library& library) {
    const auto folder = std::filesystem::absolute(wishes.out).parent_path();
    project.library_path =
        std::filesystem::absolute(wishes.library).lexically_relative(folder).generic_string();
    project.library_hash = library.content_hash();
}

void print(const tiling::TessellationReport& report, const Project& project, const Wishes& wishes) {
    if (wishes.json) {
        const base::detail::Json json = {{"tiles", report.tiles},
                                         {"interface_nodes", project.tessellation.interface_nodes.size()},
                                         {"patterns", project.tessellation.patterns.size()},
                                         {"hexagon_share", report.hexagon_share},
                                         {"inner_hexagon_share", report.inner_hexagon_share},
                                         {"mean_side", report.mean_side},
                                         {"sd_side", report.sd_side},
                                         {"smallest_side", report.smallest_side},
                                         {"covered_share", report.covered_share}};
        std::fputs(base::detail::json_text(json).c_str(), stdout);
        return;
    }
    std::printf("%d tiles, %zu interface nodes, %zu patterns in use\n", report.tiles,
                project.tessellation.interface_nodes.size(), project.tessellation.patterns.size());
    std::printf("hexagons %.0f %% (away from the rim %.0f %%), mean side %.2f mm (+- %.2f, smallest %.2f)\n",
                100 * report.hexagon_share, 100 * report.inner_hexagon_share, 1e3 * report.mean_side,
                1e3 * report.sd_side, 1e3 * report.smallest_side);
    std::printf("covers %.2f %% of the outline\n%s\n", 100 * report.covered_share, wishes.out.c_str());
}

void run(const Wishes& wishes) {
    const std::optional<Library> opened = open_library(wishes);
    const Library* library = opened ? &*opened : nullptr;
    Project project;
    project.layout = chosen_layout(wishes, library);
    project.outline = tiling::read_outline(wishes.outline);
    const tiling::TessellationOptions options{.edge_length = chosen_edge_length(wishes, library)};
    tiling::TessellationResult result = tiling::tessellate(project.outline, project.layout, options);
    project.tessellation = std::move(result.tessellation);
    paint(project.tessellation, wishes, project.layout, library);
    if (library) name_library(project, wishes, *library);
    simulation::write_project(project, wishes.out);
    print(result.report, project, wishes);
}

}  // namespace

void add_tile(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand("tile", "Cover an outline with tiles and paint them with patterns");
    const auto wishes = std::make_shared<Wishes>();
    verb->add_option("outline", wishes->outline, "Outline: SVG, DXF, JSON, or a flat OBJ, PLY or OFF")
        ->required();
    verb->add_option(
        "--edge-length", wishes->edge_length,
        "Wanted mean side of the tiles, such as 26mm (default: the library's tile side, or the paper's)");
    verb->add_option("--patterns", wishes->patterns,
                     "random:SEED, one pattern id for all tiles, or a painting file (default: not painted)");
    verb->add_option(
        "--palette", wishes->palette,
        "Patterns to choose from by chance: ids with commas between, or a painting file (default: those "
        "that the library has calibrated)");
    verb->add_option("--library", wishes->library, "Pattern library that the project is to use");
    verb->add_option("--layout", wishes->layout,
                     "Node layout: a name or a file (default: the library's, or paper7)");
    verb->add_option("--out", wishes->out, "Project file to write")->required();
    verb->add_flag("--json", wishes->json, "Print JSON");
    declare_files(*verb, {input("outline"), input("--patterns"), input("--palette"), input("--library"),
                          input("--layout"), output("--out", kProjectFile)});
    verb->footer(
        "Example: fretwork tile experiments/outlines/example_a.svg --patterns random:1 --palette "
        "0-1+1-6,0-5+5-6 "
        "--out project.json");
    verb->callback([wishes] { run(*wishes); });
}

}  // namespace fretwork::app
