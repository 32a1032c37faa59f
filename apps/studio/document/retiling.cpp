// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/painting/painting.hpp>
#include <studio/document/json_lists.hpp>
#include <studio/document/painting_request.hpp>
#include <studio/document/retiling.hpp>
#include <studio/server/sent_file.hpp>
#include <studio/solving/first_painting.hpp>

#include <algorithm>

namespace fretwork::studio {
namespace {

using base::Json;
using base::JsonReader;
using simulation::Project;

constexpr std::string_view kKeep = "keep";
constexpr std::string_view kMade = "made:one";

std::optional<pattern::NodeLayout> read_other_layout(const JsonReader& json, const State& state) {
    const auto name = json.find("layout");
    if (!name) return std::nullopt;
    const std::string text = read_name_or_path(*name);
    // The document has its own layout: a search by name would not find it if its file lies elsewhere.
    if (text == state.ground->layout.name()) return std::nullopt;
    pattern::NodeLayout layout = pattern::find_node_layout(text);
    if (layout == state.ground->layout) return std::nullopt;
    return layout;
}

/// Checks the id before any tile is made.
std::optional<pattern::NamedPattern> one_pattern(const RetileRequest& wanted, const State& state) {
    if (wanted.patterns == kKeep || wanted.patterns == kMade) return std::nullopt;
    const pattern::NodeLayout& layout = wanted.options.layout.value_or(state.ground->layout);
    return tiling::make_palette(layout, std::vector{wanted.patterns}).front();
}

/// The pattern that can be made on new tiles, or why there is none.
void find_pattern(const State& state, Retiling& made, const base::Control& control) {
    Project project = make_project(state, "/");
    project.layout = made.tiles.layout;
    project.tessellation = made.tiles.tessellation;
    project.load_cases.clear();
    project.tile_models.clear();
    project.recipes.clear();
    project.library_path.clear();
    made.remark = paint_to_be_made(project, control);
    if (made.remark.empty()) made.pattern = project.tessellation.patterns.front();
}

/// Follows the recipes again, each on its new tiles.
State painted_by_place(State next) {
    next.painting = std::make_shared<const Painting>(painted_again(next));
    return next;
}

/// All tiles with one pattern, or bare.
State painted_with(State next, const std::optional<pattern::NamedPattern>& pattern) {
    Painting painting = *next.painting;
    int place = -1;
    if (pattern) {
        const auto found = std::ranges::find(painting.palette, *pattern);
        place = static_cast<int>(found - painting.palette.begin());
        if (found == painting.palette.end()) painting.palette.push_back(*pattern);
    }
    std::ranges::fill(painting.patterns, place);
    std::ranges::fill(painting.recipes, nullptr);
    next.painting = std::make_shared<const Painting>(std::move(painting));
    return next;
}

/// The number of tiles that each kind of recipe has painted.
Json painted_again_json(const Painting& painting) {
    Json counts = Json::object();
    for (const auto& recipe : painting.recipes) {
        if (!recipe) continue;
        const std::string kind = kind_of(*recipe);
        counts[kind] = counts.value(kind, 0) + 1;
    }
    return counts;
}

Json sides_json(const simulation::NewTiles& tiles) {
    return {{"mean", tiles.report.mean_side},
            {"deviation", tiles.report.sd_side},
            {"smallest", tiles.report.smallest_side},
            {"largest", tiles.report.largest_side}};
}

/// The polygons, for a picture of the tiles before they are taken.
void add_picture(const tiling::Tessellation& tessellation, Json& answer) {
    answer["vertices"] = points_json(tessellation.vertices);
    answer["polygons"] = Json::array();
    for (const tiling::Tile& tile : tessellation.tiles)
        answer["polygons"].push_back(numbers_json(tile.vertices));
}

Json answer_json(const State& next, const Retiling& made, const simulation::CarriedOver& carried) {
    const tiling::TessellationReport& report = made.tiles.report;
    const auto unpainted = std::ranges::count(next.painting->patterns, -1);
    Json answer = {{"tiles", report.tiles},
                   {"interface_nodes", made.tiles.tessellation.interface_nodes.size()},
                   {"side", sides_json(made.tiles)},
                   {"smallest_angle", report.smallest_angle},
                   {"hexagon_share", report.hexagon_share},
                   {"refined_share", report.refined_share},
                   {"dropped",
                    {{"supports", carried.dropped.supports},
                     {"loads", carried.dropped.loads},
                     {"prescribed", carried.dropped.prescribed}}},
                   {"painted_again", painted_again_json(*next.painting)},
                   {"unpainted", unpainted},
                   {"remarks", made.remark.empty() ? Json::array() : Json{made.remark}}};
    return answer;
}

}  // namespace

RetileRequest read_retile(const JsonReader& json, const State& state) {
    json.allow_only({"id", "do", "tile_size", "angle", "layout", "patterns", "preview"});
    RetileRequest wanted;
    wanted.options.edge_length = json.at("tile_size").positive_number();
    if (const auto angle = json.find("angle")) wanted.options.angle = angle->number();
    wanted.options.layout = read_other_layout(json, state);
    if (const auto patterns = json.find("patterns")) wanted.patterns = read_plain_text(*patterns);
    if (const auto preview = json.find("preview"))
        wanted.preview = preview->boolean() ? Preview::Yes : Preview::No;
    if (wanted.options.layout && wanted.patterns == kKeep)
        throw base::InputError("patterns of the layout " + state.ground->layout.name() +
                               " cannot be kept with " + wanted.options.layout->name() +
                               ": choose one pattern for all tiles");
    (void)one_pattern(wanted, state);
    return wanted;
}

Retiling make_retiling(const StatePtr& state, const RetileRequest& wanted, const base::Control& control) {
    Retiling made{.of = state, .wanted = wanted, .tiles = {}, .pattern = one_pattern(wanted, *state)};
    simulation::RetilingOptions options = wanted.options;
    options.control = control;
    made.tiles = simulation::new_tiles(make_project(*state, "/"), options);
    if (wanted.patterns == kMade) find_pattern(*state, made, control);
    return made;
}

bool gives_the_same(const Retiling& known, const State& state, const RetileRequest& wanted) {
    const simulation::RetilingOptions& a = known.wanted.options;
    const simulation::RetilingOptions& b = wanted.options;
    const bool is_same = a.edge_length == b.edge_length && a.angle == b.angle && a.layout == b.layout;
    return is_same && known.of->ground == state.ground && known.of->setting == state.setting &&
           known.wanted.patterns == wanted.patterns;
}

Retiled retiled(const State& state, const Retiling& made, Preview preview) {
    const simulation::CarriedOver carried = simulation::carry_over(make_project(state, "/"), made.tiles);
    State next = make_state(carried.project, "/");
    next.setting = state.setting;
    next.model = state.model;
    next.analysis = state.analysis;
    if (!made.wanted.options.layout) next.library = state.library;
    next = made.wanted.patterns == kKeep ? painted_by_place(std::move(next))
                                         : painted_with(std::move(next), made.pattern);
    Json answer = answer_json(next, made, carried);
    if (preview == Preview::Yes) add_picture(made.tiles.tessellation, answer);
    const std::string side = base::format_number(1e3 * made.wanted.options.edge_length.value(), 3);
    return {{std::move(next), "tiles of " + side + " mm"}, std::move(answer)};
}

}  // namespace fretwork::studio
