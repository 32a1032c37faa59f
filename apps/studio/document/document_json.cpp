// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/internal/node_json.hpp>
#include <fretwork/reduction/internal/setting_json.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/tiling/tessellation.hpp>
#include <studio/document/document_json.hpp>
#include <studio/document/json_lists.hpp>

namespace fretwork::studio {
namespace {

using base::Json;
using mechanics::vector_json;

/// The nodes along each side of the box, as a selection by side picks them.
Json sides_json(const tiling::Tessellation& tessellation) {
    Json sides;
    for (std::size_t s = 0; s < simulation::kSideNames.size(); ++s) {
        const simulation::NodesAtSide side{static_cast<simulation::Side>(s)};
        sides[simulation::kSideNames[s]] = numbers_json(simulation::select_nodes(side, tessellation));
    }
    return sides;
}

void add_ground(const State& state, Json& event) {
    const tiling::Tessellation& tessellation = state.ground->tessellation;
    event["layout"] = state.ground->layout.name();
    event["layout_nodes"] = layout_nodes_json(state.ground->layout);
    event["vertices"] = points_json(tessellation.vertices);
    event["tiles"] = Json::array();
    for (const tiling::Tile& tile : tessellation.tiles)
        event["tiles"].push_back(
            {{"vertices", numbers_json(tile.vertices)}, {"interface", numbers_json(tile.interface_nodes)}});
    event["interface_nodes"] = points_json(tessellation.interface_nodes);
    event["rim"] = Json::array();
    for (const auto& loop : tiling::rim_loops(tessellation)) event["rim"].push_back(numbers_json(loop));
    event["sides"] = sides_json(tessellation);
}

void add_painting(const State& state, Json& event) {
    event["palette"] = pattern::ids_of(state.painting->palette);
    event["painting"] = state.painting->patterns;
    event["turns"] = state.painting->turns;
}

template <class Index>
Json lists_of_numbers(const std::vector<std::vector<Index>>& lists) {
    Json all = Json::array();
    for (const auto& list : lists) all.push_back(numbers_json(list));
    return all;
}

/// The nodes of each entry of a load case, and their loads, so that no page has to compute them.
Json marks_json(const simulation::EntryMarks& marks) {
    Json loads = Json::array();
    for (const simulation::EntryMarks::Load& load : marks.loads)
        loads.push_back({{"nodes", numbers_json(load.nodes)},
                         {"shares", load.shares},
                         {"force", vector_json(load.force)},
                         {"moment", vector_json(load.moment)},
                         {"extent", load.extent > 0.0 ? Json(load.extent) : Json()}});
    return {{"supports", lists_of_numbers(marks.supports)},
            {"loads", std::move(loads)},
            {"prescribed", lists_of_numbers(marks.prescribed)}};
}

void add_load_cases(const State& state, Json& event) {
    event["load_cases"] = Json::array();
    for (const simulation::LoadCase& load_case : *state.load_cases) {
        Json json = simulation::load_case_json(load_case);
        json.erase("format");
        json["marks"] = marks_json(simulation::entry_marks(load_case, state.ground->tessellation));
        event["load_cases"].push_back(std::move(json));
    }
}

void add_model(const State& state, Json& event) {
    event["model"] = *state.model;
    event["linear"] = state.analysis == simulation::Analysis::Linear;
}

void add_setting(const State& state, Json& event) {
    event["setting"] = reduction::setting_json(*state.setting);
}

void add_status(const DocumentStatus& status, Json& event) {
    event["saved"] = status.is_saved;
    event["selected_load_case"] = status.selected_load_case;
    event["history"] = {{"undo", base::or_null(status.undo)}, {"redo", base::or_null(status.redo)}};
}

void add_place(const State& state, const DocumentStatus& status, Json& event) {
    event["name"] = status.name;
    event["path"] = base::or_null(status.path);
    event["library"] = state.library->path.empty() ? Json() : Json(state.library->path.string());
}

Json started(const char* name, const DocumentStatus& status) {
    return {{"event", name}, {"revision", status.revision}};
}

}  // namespace

Json layout_nodes_json(const pattern::NodeLayout& layout) {
    Json nodes = Json::array();
    for (const pattern::LayoutNode& node : layout.nodes()) {
        Json place = Json::array();
        for (const pattern::Rational& share : node.place) place.push_back(share.to_double());
        nodes.push_back(std::move(place));
    }
    return nodes;
}

Json document_event(const State& state, const DocumentStatus& status) {
    Json event = started("document", status);
    add_place(state, status, event);
    event["recovered"] = status.is_recovered;
    add_status(status, event);
    add_ground(state, event);
    add_painting(state, event);
    event["tile_models"] = *state.tile_models;
    add_setting(state, event);
    add_load_cases(state, event);
    add_model(state, event);
    return event;
}

Json changed_event(const State& before, const State& now, const DocumentStatus& status) {
    Json event = started("changed", status);
    add_place(now, status, event);
    add_status(status, event);
    const bool is_retiled = before.ground != now.ground;
    if (is_retiled) add_ground(now, event);
    if (is_retiled || before.painting != now.painting) add_painting(now, event);
    if (is_retiled || before.tile_models != now.tile_models) event["tile_models"] = *now.tile_models;
    if (before.setting != now.setting) add_setting(now, event);
    if (is_retiled || before.load_cases != now.load_cases) add_load_cases(now, event);
    if (before.model != now.model || before.analysis != now.analysis) add_model(now, event);
    return event;
}

}  // namespace fretwork::studio
