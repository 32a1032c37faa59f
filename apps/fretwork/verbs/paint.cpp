// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork paint: patterns into the tiles of a project.
#include "bar_checks.hpp"
#include "options/file_options.hpp"
#include "options/painting_options.hpp"
#include "output.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file_lock.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace fretwork::app {
namespace {

using simulation::Project;
using tiling::TileIndex;

struct PaintOptions {
    std::string project;
    std::string out;
    std::string library;
    std::vector<std::string> tiles;
    std::vector<std::string> boxes;
    std::vector<std::string> circles;
    std::vector<std::string> polygons;
    typed::PaintingText painting;
    int turn = 0;
    std::string clearance;
    bool mirror = false;
    bool json = false;
};

/// Lengths with commas or blanks between.
std::vector<double> parse_lengths(const std::string& text) {
    std::vector<double> lengths;
    std::string words = text;
    for (char& c : words) c = c == ' ' ? ',' : c;
    for (const std::string& word : base::split(words, ','))
        if (!word.empty()) lengths.push_back(base::parse_length(word));
    return lengths;
}

geometry::Box parse_box(const std::string& text) {
    const auto sides = parse_lengths(text);
    if (sides.size() != 4)
        throw base::InputError("'" + text +
                               "' is not a box: expected XMIN,YMIN,XMAX,YMAX, such as 0,0,100mm,50mm");
    for (const auto& [most, name] : {std::pair(2U, "XMAX"), std::pair(3U, "YMAX")})
        if (sides[most] < sides[most - 2])
            throw base::InputError("'" + text + "' is not a box: its " + name +
                                   " is less than its minimum (XMIN,YMIN,XMAX,YMAX)");
    return {sides[0], sides[1], sides[2], sides[3]};
}

geometry::Circle parse_circle(const std::string& text) {
    const auto lengths = parse_lengths(text);
    if (lengths.size() != 3)
        throw base::InputError("'" + text +
                               "' is not a circle: expected X,Y,RADIUS, such as 100mm,50mm,20mm");
    if (!(lengths[2] > 0.0))
        throw base::InputError("'" + text + "' is not a circle: its RADIUS is not above zero (X,Y,RADIUS)");
    return {{lengths[0], lengths[1]}, lengths[2]};
}

geometry::Polygon parse_polygon(const std::string& text) {
    const auto numbers = parse_lengths(text);
    if (numbers.size() % 2 != 0)
        throw base::InputError("'" + text + "' has " + std::to_string(numbers.size()) +
                               " numbers, where points need two each");
    geometry::Polygon corners;
    for (std::size_t i = 0; i < numbers.size(); i += 2) corners.push_back({numbers[i], numbers[i + 1]});
    if (corners.size() < 3)
        throw base::InputError("'" + text + "' is not a polygon: it needs three corners or more");
    return corners;
}

/// Calls `pick` for each value of an option; errors name the option.
template <class Pick>
void add_tiles(std::set<TileIndex>& chosen, const char* option, const std::vector<std::string>& values,
               const Pick& pick) {
    for (const std::string& value : values) {
        const auto tiles = base::located(option, "", [&] { return pick(value); });
        chosen.insert(tiles.begin(), tiles.end());
    }
}

/// The tiles that the options select, or all tiles if none of these options is given.
std::vector<TileIndex> chosen_tiles(const PaintOptions& options, const tiling::Tessellation& tessellation) {
    std::set<TileIndex> chosen;
    add_tiles(chosen, "--tiles", options.tiles,
              [&](const std::string& text) { return tiling::parse_tiles(text, tessellation); });
    add_tiles(chosen, "--box", options.boxes,
              [&](const std::string& text) { return tiling::tiles_in(parse_box(text), tessellation); });
    add_tiles(chosen, "--circle", options.circles,
              [&](const std::string& text) { return tiling::tiles_in(parse_circle(text), tessellation); });
    add_tiles(chosen, "--polygon", options.polygons,
              [&](const std::string& text) { return tiling::tiles_in(parse_polygon(text), tessellation); });
    if (options.tiles.empty() && options.boxes.empty() && options.circles.empty() &&
        options.polygons.empty()) {
        for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) chosen.insert(TileIndex(t));
    }
    return {chosen.begin(), chosen.end()};
}

/// The library with the patterns; none without --patterns.
std::optional<library::Library> open_library(const Project& project, const PaintOptions& options) {
    if (options.painting.patterns.empty()) return std::nullopt;
    auto library = simulation::open_project_library(options.project, project, options.library);
    if (library) library->check_layout(project.layout);
    return library;
}

/// Returns the painted tiles: a drawing may leave some out.
std::vector<TileIndex> paint_project(Project& project, std::vector<TileIndex> tiles,
                                     const simulation::PaintingChoice& choice, const PaintOptions& options,
                                     const library::Library* library) {
    if (!options.painting.patterns.empty()) {
        try {
            tiles = simulation::paint(project, tiles, choice, library);
        } catch (const base::InputError& error) {
            throw with_option_name(error);
        }
    }
    if (options.mirror) {
        simulation::mirror(project.tessellation, tiles, project.layout);
        simulation::end_recipes(project, tiles);
    }
    for (const TileIndex tile : tiles) tiling::turn(project.tessellation.tiles[tile], options.turn);
    return tiles;
}

/// How many of these tiles have each pattern.
std::map<std::string, int> pattern_counts(const tiling::Tessellation& tessellation,
                                          const std::vector<TileIndex>& tiles) {
    std::map<std::string, int> counts;
    for (const TileIndex tile : tiles) {
        const int pattern = tessellation.tiles[tile].pattern;
        if (pattern >= 0) ++counts[tessellation.patterns[static_cast<std::size_t>(pattern)].id];
    }
    return counts;
}

void print(const Project& project, const std::vector<TileIndex>& tiles, const PaintOptions& options) {
    const auto counts = pattern_counts(project.tessellation, tiles);
    const std::size_t unpainted = unpainted_count(project.tessellation);
    if (options.json) {
        std::vector<int> numbers;
        for (const TileIndex tile : tiles) numbers.push_back(tile.value);
        return print_document({{"tiles", numbers}, {"patterns", counts}, {"unpainted_tiles", unpainted}});
    }
    std::printf("%zu of %zu tiles:\n", tiles.size(), project.tessellation.tiles.size());
    for (const auto& [pattern, count] : counts) std::printf("%6d  %s\n", count, pattern.c_str());
    if (unpainted > 0) std::printf("not painted yet: %zu\n", unpainted);
    if (!project.load_cases.empty())
        std::printf("load cases kept: %zu; earlier results belong to another painting\n",
                    project.load_cases.size());
}

ExitCode run(const PaintOptions& options) {
    const simulation::PaintingChoice choice = typed::read_painting(options.painting);
    const std::string& target = options.out.empty() ? options.project : options.out;
    std::optional<base::FileLock> lock;
    if (std::filesystem::exists(target)) lock.emplace(target);
    Project project = simulation::read_checked_project(options.project);
    const auto library = open_library(project, options);
    const library::Library* given = library ? &*library : nullptr;
    const auto chosen = chosen_tiles(options, project.tessellation);
    const auto tiles = paint_project(project, chosen, choice, options, given);
    if (tiles.empty()) {
        const std::string reason =
            chosen.empty() ? "no tile lies there" : "none of the palette's colours lies on these tiles";
        warn(reason + "; nothing is painted");
        return ExitCode::DidNotSucceed;
    }
    simulation::move_library_path(project, options.project, target);
    simulation::write_project(project, target);
    print(project, tiles, options);
    if (!options.mirror) warn_of_unkept_file(project, choice, tiles);
    warn_of_close_bars(project, given, options.clearance);
    return ExitCode::Done;
}

}  // namespace

void add_paint(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb =
        app.add_subcommand("paint", "Paint tiles of a project with patterns, and change nothing else");
    const auto options = std::make_shared<PaintOptions>();
    verb->add_option("project", options->project, "Project file")->required();
    verb->add_option("--tiles", options->tiles,
                     "Tiles by number, with ranges: 3,7-11; export --labels tiles draws the numbers (default "
                     "without --box, --circle and --polygon: all tiles)");
    verb->add_option("--box", options->boxes,
                     "Tiles whose middle lies in a box, such as 0,0,100mm,50mm (repeatable)")
        ->type_name("XMIN,YMIN,XMAX,YMAX")
        ->allow_extra_args(false);
    verb->add_option("--circle", options->circles,
                     "Tiles whose middle lies in a circle, such as 100mm,50mm,20mm (repeatable)")
        ->type_name("X,Y,RADIUS")
        ->allow_extra_args(false);
    verb->add_option("--polygon", options->polygons,
                     "Tiles whose middle lies in a polygon, such as '0,0 0.1,0 0.1,0.2' (repeatable)")
        ->type_name("X,Y X,Y ..")
        ->allow_extra_args(false);
    add_painting_options(*verb, options->painting);
    verb->add_flag("--mirror", options->mirror,
                   "Replace the pattern of each selected tile by its mirror image");
    verb->add_option("--turn", options->turn,
                     "Turn the pattern of each tile by this number of vertices. The tile looks the same, "
                     "because a pattern repeats in every sector of its tile")
        ->check(CLI::Range(-1000, 1000));
    add_clearance_option(*verb, options->clearance);
    verb->add_option("--library", options->library,
                     "Library with patterns and properties (default: the project's)");
    verb->add_option("--out", options->out, "Project file to write (default: the project itself)");
    verb->add_flag(
        "--json", options->json,
        "Print JSON: the tiles, the number of tiles for each pattern, the number of unpainted tiles");
    declare_files(*verb, {update("project", kProjectFile), input("--patterns"), input("--palette"),
                          input("--library"), output("--out", kProjectFile)});
    verb->footer(
        "Example: fretwork paint project.json --box 0,0,100mm,1 --patterns 0-1+1-6\n"
        "         fretwork paint project.json --patterns colours:regions.svg --palette "
        "red=0-1+1-6,#00f=0-5+5-6\n"
        "         fretwork paint project.json --patterns field:u --palette 0-1+1-6,0-5+5-6 --property "
        "bending_stiffness --dither");
    verb->callback([options, verb, &exit_code] {
        const bool has_work =
            !options->painting.patterns.empty() || options->mirror || verb->count("--turn") > 0;
        if (!has_work)
            throw base::InputError("paint", "",
                                   "needs --patterns, --mirror or --turn: what is to be painted?");
        exit_code = run(*options);
    });
}

}  // namespace fretwork::app
