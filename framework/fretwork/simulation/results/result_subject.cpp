// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/sha256.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/internal/stages_json.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/stages.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

namespace fretwork::simulation {
namespace {

using tiling::Tessellation;
using tiling::Tile;

/// Hash the count and bytes of values.
template <class Value>
void update(base::Sha256& hash, const std::vector<Value>& values) {
    static_assert(std::is_trivially_copyable_v<Value>);
    hash.update(std::to_string(values.size()) + ":");
    hash.update({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)});
}

/// The number of vertices before the one with the smallest index.
std::ptrdiff_t first_place(const Tile& tile) {
    return std::ranges::min_element(tile.vertices) - tile.vertices.begin();
}

std::string tessellation_hash(const Surface& surface) {
    const Tessellation& tessellation = surface.tessellation;
    base::Sha256 hash;
    hash.update(pattern::node_layout_text(surface.layout));
    update(hash, tessellation.vertices);
    update(hash, tessellation.interface_nodes);
    for (Tile tile : tessellation.tiles) {
        tiling::turn(tile, static_cast<int>(first_place(tile)));
        update(hash, tile.vertices);
        update(hash, tile.interface_nodes);
    }
    return hash.hexadecimal();
}

std::string painting_hash(const Tessellation& tessellation) {
    base::Sha256 hash;
    for (const Tile& tile : tessellation.tiles) {
        const std::string id = tile.pattern < 0 ? "-" : tessellation.patterns[tile.pattern].id;
        hash.update(id + " " + std::to_string(first_place(tile)) + "\n");
    }
    return hash.hexadecimal();
}

/// "condensed", or "condensed; full (3 tiles)".
std::string model_text(const Surface& surface, const SimulationOptions& options) {
    std::map<std::string, std::size_t> others;
    for (const std::string& model : surface.tile_models) {
        if (!model.empty() && model != options.model) ++others[model];
    }
    std::string text = options.model;
    for (const auto& [model, count] : others) text += "; " + model + " (" + std::to_string(count) + " tiles)";
    return text;
}

/// The models in a model_text(); the first is the model of tiles without their own tile model.
std::vector<std::string> named_models(const std::string& text) {
    std::vector<std::string> names;
    for (const std::string& part : base::split(text, ';')) {
        const std::size_t start = part.find_first_not_of(' ');
        const std::string name = start == std::string::npos ? "" : part.substr(start);
        names.push_back(names.empty() ? name : name.substr(0, name.find(" (")));
    }
    return names;
}

/// The load case without description, which changes no displacement.
std::string content_of(const std::string& load_case_text) {
    LoadCase load_case = parse_load_case(load_case_text, "the load case of a result");
    load_case.description.clear();
    return simulation::load_case_text(load_case);
}

/// Equal texts are not parsed: a load case that was not read may have what files refuse, such as no name.
bool have_same_content(const std::string& left, const std::string& right) {
    return left == right || content_of(left) == content_of(right);
}

bool have_same_stages_text(const std::string& left, const std::string& right) {
    if (left == right || left.empty() || right.empty()) return left == right;
    const auto content = [](const std::string& text) {
        return stages_text(parse_stages(text, "the stages of a result"));
    };
    return content(left) == content(right);
}

bool has_same_stages(const ResultSubject& left, const ResultSubject& right) {
    return have_same_stages_text(left.stages_text, right.stages_text) &&
           std::ranges::equal(left.stage_load_cases, right.stage_load_cases, have_same_content);
}

}  // namespace

ResultSubject result_subject(const Surface& surface, const LoadCase& load_case,
                             const SimulationOptions& options,
                             std::span<const tiling::TileIndex> full_tiles) {
    SurfaceIdentity identity = surface_identity(surface);
    return {.model = model_text(surface, options),
            .is_reference = is_reference(surface, options),
            .load_case = load_case.name,
            .load_case_text = load_case_text(load_case),
            .tessellation_hash = std::move(identity.tessellation_hash),
            .painting_hash = std::move(identity.painting_hash),
            .setting_hash = std::move(identity.setting_hash),
            .joints = surface.setting.joints,
            .full_tiles = tile_numbers(full_tiles)};
}

std::vector<int> tile_numbers(std::span<const tiling::TileIndex> tiles) {
    std::vector<int> numbers;
    for (const tiling::TileIndex tile : tiles) numbers.push_back(tile.value);
    return numbers;
}

std::string main_model(const ResultSubject& subject) {
    return named_models(subject.model).front();
}

void check_subject(const ResultSubject& subject, const std::string& source,
                   std::span<const reduction::TileModel> models) {
    bool may_be_reference = false;
    bool must_be_reference = true;
    base::located(source, "/subject/model", [&] {
        for (const std::string& name : named_models(subject.model)) {
            const bool is_full =
                reduction::find_tile_model(model_choice({.model = name, .models = models}).name, models)
                    .role == reduction::Role::Reference;
            may_be_reference = may_be_reference || is_full;
            must_be_reference = must_be_reference && is_full;
        }
    });
    if (subject.is_reference ? !may_be_reference : must_be_reference)
        throw base::InputError(source, "/subject/is_reference", "does not agree with the model");
    if (!subject.full_tiles.empty() && !mixed_share(main_model(subject)))
        throw base::InputError(source, "/subject/full_tiles",
                               "is for mixed models, and this is " + subject.model);
    const auto part = [&](const std::string& text, const std::string& place) {
        return base::JsonReader::from_text(text, source, "/subject/" + place);
    };
    (void)read_load_case(part(subject.load_case_text, "load_case"));
    if (!subject.stages_text.empty()) (void)read_stages(part(subject.stages_text, "stages"));
    for (std::size_t i = 0; i < subject.stage_load_cases.size(); ++i)
        (void)read_load_case(part(subject.stage_load_cases[i], "stage_load_cases/" + std::to_string(i)));
}

std::string subject_difference(const ResultSubject& left, const ResultSubject& right) {
    std::vector<std::string> differences;
    if (left.tessellation_hash != right.tessellation_hash) differences.emplace_back("the tessellation");
    if (left.painting_hash != right.painting_hash) differences.emplace_back("the painting");
    if (left.setting_hash != right.setting_hash) differences.emplace_back("the setting");
    if (left.load_case != right.load_case) {
        differences.push_back("the load case ('" + left.load_case + "' and '" + right.load_case + "')");
    } else if (!have_same_content(left.load_case_text, right.load_case_text)) {
        differences.push_back("what the load case '" + left.load_case + "' holds");
    }
    if (!has_same_stages(left, right)) differences.emplace_back("the stages");
    return base::join(differences, ", ");
}

SurfaceIdentity surface_identity(const Surface& surface) {
    return {
        .tessellation_hash = tessellation_hash(surface),
        .painting_hash = painting_hash(surface.tessellation),
        .setting_hash = base::sha256(reduction::setting_text(reduction::without_stresses(surface.setting))),
        .tiles = surface.tessellation.tiles.size()};
}

std::string subject_difference(const ResultSubject& result, const SurfaceIdentity& surface) {
    ResultSubject own = result;
    own.tessellation_hash = surface.tessellation_hash;
    own.painting_hash = surface.painting_hash;
    own.setting_hash = surface.setting_hash;
    std::string difference = subject_difference(result, own);
    const auto& full = result.full_tiles;
    if (!difference.empty() || full.empty() || static_cast<std::size_t>(full.back()) < surface.tiles)
        return difference;
    return "the number of tiles (tile " + std::to_string(full.back()) + " is in full)";
}

}  // namespace fretwork::simulation
