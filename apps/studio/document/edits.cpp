// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/reduction/internal/setting_json.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/internal/origins.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <studio/document/edits.hpp>
#include <studio/document/painting_request.hpp>

#include <algorithm>

namespace fretwork::studio {

using base::JsonReader;

std::string read_model(const JsonReader& json, Mixed mixed) {
    std::string name = json.string();
    return json.located([&] {
        if (mixed == Mixed::Taken && simulation::mixed_share(name)) return name;
        return reduction::find_tile_model(name).name;
    });
}

namespace {

using simulation::LoadCase;

/// An equal value leaves the part as it is: then the edit changes nothing.
template <class Value>
void change(State::Part<Value>& part, Value value) {
    if (*part != value) part = std::make_shared<const Value>(std::move(value));
}

Edited paint(const State& state, const JsonReader& request) {
    Painted result = painted(state, request);
    Edited edit{state, "paint " + base::counted(result.tiles, "tile")};
    change(edit.state.painting, std::move(result.painting));
    edit.remarks = std::move(result.remarks);
    return edit;
}

Edited turn(const State& state, const JsonReader& request) {
    request.allow_only({"id", "do", "merge", "tiles", "by"});
    const auto tiles = read_tiles(request.at("tiles"), state);
    const auto by = request.at("by").integer(-1000, 1000);
    Painting painting = *state.painting;
    for (const std::size_t tile : tiles) {
        const auto sides = static_cast<long long>(state.ground->tessellation.tiles[tile].vertices.size());
        painting.turns[tile] = static_cast<int>(((painting.turns[tile] + by) % sides + sides) % sides);
    }
    Edited edit{state, "turn " + base::counted(tiles.size(), "tile")};
    change(edit.state.painting, std::move(painting));
    return edit;
}

Edited set_model(const State& state, const JsonReader& request) {
    request.allow_only({"id", "do", "merge", "model", "linear"});
    const std::string model = read_model(request.at("model"), Mixed::Taken);
    Edited edit{state, "model " + model};
    change(edit.state.model, model);
    if (const auto linear = request.find("linear"))
        edit.state.analysis =
            linear->boolean() ? simulation::Analysis::Linear : simulation::Analysis::OfTheModel;
    return edit;
}

Edited set_tile_model(const State& state, const JsonReader& request) {
    request.allow_only({"id", "do", "merge", "tiles", "model"});
    const auto tiles = read_tiles(request.at("tiles"), state);
    const JsonReader name = request.at("model");
    const std::string model = name.string().empty() ? "" : read_model(name, Mixed::Refused);
    auto models = *state.tile_models;
    for (const std::size_t tile : tiles) models[tile] = model;
    Edited edit{state, "model of " + base::counted(tiles.size(), "tile")};
    change(edit.state.tile_models, std::move(models));
    return edit;
}

/// With another setting the library's calibrations do not fit: then the document has no library any more.
Edited set_setting(const State& state, const JsonReader& request) {
    request.allow_only({"id", "do", "merge", "setting"});
    Edited edit{state, "material and section"};
    const auto setting = reduction::read_setting(request.at("setting"));
    if (setting == *state.setting) return edit;
    edit.state.setting = std::make_shared<const reduction::Setting>(setting);
    const bool is_other = !reduction::setting_difference(setting, *state.setting).empty();
    if (is_other && !state.library->path.empty()) edit.state.library = std::make_shared<const LibraryLink>();
    return edit;
}

std::size_t read_index(const JsonReader& json, std::size_t last) {
    return json.integer(0, static_cast<long long>(last));
}

/// A message has the newest format of files, unless it names another. Marks are left out: a page may send a
/// load case back with the marks that the server has added.
LoadCase read_load_case(const JsonReader& json) {
    base::Json value = base::Json::parse(json.text());
    if (value.is_object() && !value.contains("format")) value["format"] = simulation::kLoadCaseFormat;
    if (value.is_object()) value.erase("marks");
    return simulation::read_load_case(JsonReader::from_text(value.dump(), json.source(), json.pointer()));
}

Edited set_load_case(const State& state, const JsonReader& request) {
    request.allow_only({"id", "do", "merge", "index", "load_case"});
    auto cases = *state.load_cases;
    const std::size_t index = read_index(request.at("index"), cases.size());
    const JsonReader json = request.at("load_case");
    LoadCase load_case = read_load_case(json);
    simulation::check_selections(load_case, state.ground->tessellation);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (i != index && cases[i].name == load_case.name)
            json.at("name").fail("'" + load_case.name + "' is the name of another load case");
    }
    load_case = simulation::without_origins(std::move(load_case));
    Edited edit{state, (index == cases.size() ? "new load case " : "load case ") + load_case.name};
    if (index == cases.size())
        cases.push_back(std::move(load_case));
    else if (cases[index] == load_case)
        return edit;
    else
        cases[index] = std::move(load_case);
    simulation::check_combinations(cases);
    edit.state.load_cases = std::make_shared<const std::vector<LoadCase>>(std::move(cases));
    return edit;
}

Edited remove_load_case(const State& state, const JsonReader& request) {
    request.allow_only({"id", "do", "merge", "index"});
    auto cases = *state.load_cases;
    const JsonReader json = request.at("index");
    if (cases.empty()) json.fail("there is no load case to remove");
    const std::size_t index = read_index(json, cases.size() - 1);
    Edited edit{state, "remove load case " + cases[index].name};
    cases.erase(cases.begin() + index);
    simulation::check_combinations(cases);
    edit.state.load_cases = std::make_shared<const std::vector<LoadCase>>(std::move(cases));
    return edit;
}

struct EditRow {
    std::string_view name;
    Edited (*make)(const State&, const JsonReader&);
};
constexpr EditRow kEdits[] = {
    {"paint", paint},
    {"turn", turn},
    {"set_model", set_model},
    {"set_tile_model", set_tile_model},
    {"set_setting", set_setting},
    {"set_load_case", set_load_case},
    {"remove_load_case", remove_load_case},
};

}  // namespace

std::optional<Edited> edited(const State& state, std::string_view name, const JsonReader& request) {
    const auto row = std::ranges::find(kEdits, name, &EditRow::name);
    if (row == std::end(kEdits)) return std::nullopt;
    Edited edit = row->make(state, request);
    if (const auto merge = request.find("merge")) edit.merge = std::string(name) + ":" + merge->string();
    return edit;
}

}  // namespace fretwork::studio
