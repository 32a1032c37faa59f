// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/internal/stages_json.hpp>
#include <fretwork/simulation/stages.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace fretwork::simulation {
namespace {

using base::Json;
using base::JsonReader;

LoadStage read_stage(const JsonReader& json) {
    json.allow_only({"name", "loads", "prescribed", "keep", "free"});
    LoadStage stage;
    stage.name = json.at("name").string();
    if (const auto loads = json.find("loads")) {
        std::set<std::string> named;
        for (const JsonReader& share : loads->elements()) {
            stage.loads.push_back(read_share(share));
            const JsonReader name = share.at("load_case");
            if (!named.insert(stage.loads.back().load_case).second)
                name.fail("is " + name.text() + ", which this load stage names already");
        }
    }
    if (const auto keep = json.find("keep")) stage.keep = read_supports(*keep);
    if (const auto prescribed = json.find("prescribed")) stage.prescribed = read_prescribed(*prescribed);
    if (const auto free = json.find("free")) stage.free = read_supports(*free);
    if (stage.is_empty()) json.fail("changes nothing: it needs one of loads, prescribed, keep, free");
    return stage;
}

Json stage_json(const LoadStage& stage) {
    Json json = {{"name", stage.name}};
    for (const LoadCase::Share& share : stage.loads)
        json["loads"].push_back({{"load_case", share.load_case}, {"factor", share.factor}});
    if (!stage.prescribed.empty()) json["prescribed"] = prescribed_json(stage.prescribed);
    if (!stage.keep.empty()) json["keep"] = supports_json(stage.keep);
    if (!stage.free.empty()) json["free"] = supports_json(stage.free);
    return json;
}

bool has_circle(const LoadStage& stage) {
    const auto on_circle = [](const auto& entry) { return is_circle(entry.where); };
    return std::ranges::any_of(stage.prescribed, on_circle) || std::ranges::any_of(stage.keep, on_circle) ||
           std::ranges::any_of(stage.free, on_circle);
}

}  // namespace

std::vector<LoadStage> read_stages(const JsonReader& json) {
    json.expect_format("stages", 2);
    json.allow_only({"format", "stages"});
    std::vector<LoadStage> stages;
    bool may_be_held = false;  // a load case of a stage may prescribe displacements, too
    for (const JsonReader& entry : json.at("stages").elements()) {
        LoadStage stage = read_stage(entry);
        const auto same = std::ranges::find(stages, stage.name, &LoadStage::name);
        if (same != stages.end())
            entry.at("name").fail("'" + stage.name + "' is the name of /stages/" +
                                  std::to_string(same - stages.begin()) +
                                  " already; each stage needs a name of its own");
        may_be_held = may_be_held || !stage.loads.empty();
        if (!may_be_held && !stage.free.empty())
            entry.at("free").fail("releases nothing: no load stage has prescribed or kept anything before");
        may_be_held = may_be_held || !stage.prescribed.empty() || !stage.keep.empty();
        stages.push_back(std::move(stage));
    }
    if (stages.empty()) json.at("stages").fail("is empty, where at least one stage is needed");
    if (std::ranges::any_of(stages, has_circle)) json.require_format("fretwork/stages/2", "circle");
    return stages;
}

std::vector<LoadStage> parse_stages(std::string_view text, const std::string& source) {
    return read_stages(JsonReader::from_text(text, source));
}

std::string stages_text(std::span<const LoadStage> stages) {
    // Older programs read all but circles.
    const bool is_second = std::ranges::any_of(stages, has_circle);
    Json json = {{"format", is_second ? "fretwork/stages/2" : "fretwork/stages/1"},
                 {"stages", Json::array()}};
    for (const LoadStage& stage : stages) json["stages"].push_back(stage_json(stage));
    return base::json_text(json);
}

std::vector<LoadStage> read_stages(const std::filesystem::path& path) {
    return parse_stages(base::read_text_file(path), path.string());
}

std::vector<std::string> stage_names(const SurfaceResult& result) {
    std::vector<std::string> names;
    if (!result.subject || result.subject->stages_text.empty()) return names;
    for (const LoadStage& stage : parse_stages(result.subject->stages_text, "stages"))
        names.push_back(stage.name);
    names.resize(std::min(names.size(), result.load_steps.size()));
    return names;
}

}  // namespace fretwork::simulation
