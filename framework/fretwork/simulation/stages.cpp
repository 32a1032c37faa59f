// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/mechanics/paths/staged_path.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/detail/tile_deformations.hpp>
#include <fretwork/simulation/detail/wanted.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/results/model_doubt.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/stages.hpp>

#include <algorithm>
#include <chrono>
#include <map>

namespace fretwork::simulation {
namespace {

using base::Json;
using base::JsonReader;

/// The lists of an entry as those of a load case, whose reader knows how places are picked.
LoadCase lists_of(const JsonReader& stage, const char* supports) {
    Json json = {{"format", "fretwork/load-case/1"}, {"name", "stage"}};
    if (const auto list = stage.find(supports)) json["supports"] = Json::parse(list->text());
    if (const auto list = stage.find("prescribed")) json["prescribed"] = Json::parse(list->text());
    try {
        return parse_load_case(base::json_text(json), "");
    } catch (const base::InputError& error) {
        stage.fail(error);
    }
}

Stage read_stage(const JsonReader& json) {
    json.allow_only({"name", "loads", "prescribed", "keep", "free"});
    Stage stage;
    stage.name = json.at("name").string();
    if (const auto loads = json.find("loads")) {
        for (const JsonReader& share : loads->elements()) {
            share.allow_only({"load_case", "factor"});
            stage.loads.push_back({share.at("load_case").string(), share.at("factor").number()});
        }
    }
    const LoadCase kept = lists_of(json, "keep");
    stage.keep = kept.supports;
    stage.prescribed = kept.prescribed;
    stage.free = lists_of(json, "free").supports;
    if (stage.loads.empty() && stage.keep.empty() && stage.prescribed.empty() && stage.free.empty())
        json.fail("changes nothing: it needs one of loads, prescribed, keep, free");
    return stage;
}

using Place = std::pair<int, int>;  // node and dof

/// The state between stages: which components are held beside the supports, and how much of each load case
/// acts.
class Stages {
  public:
    Stages(const Surface& surface, const LoadCase& load_case, std::span<const LoadCase> cases,
           std::size_t nodes)
        : surface_(surface), load_case_(load_case), cases_(cases), nodes_(nodes) {
        LoadCase supports;
        supports.name = load_case.name;
        supports.supports = load_case.supports;
        supports_ = resolve(supports, surface).supports;
    }

    mechanics::StageTarget target(const Stage& stage, const mechanics::NodeValues& displacements) {
        for (const LoadCase::Share& share : stage.loads) factors_[share.load_case] = share.factor;
        for (const Place& place : places_of(stage.free)) held_.erase(place);
        for (const Place& place : places_of(stage.keep))
            held_[place] = displacements(place.first, place.second);
        LoadCase prescribed;
        prescribed.name = stage.name;
        prescribed.prescribed = stage.prescribed;
        for (const auto& given : resolve(prescribed, surface_).prescribed)
            held_[{given.node.value, static_cast<int>(given.dof)}] = given.value;
        mechanics::StageTarget target{supports_, {}, loads()};
        for (const auto& [place, value] : held_)
            target.prescribed.push_back(
                {mechanics::NodeIndex(place.first), static_cast<mechanics::Dof>(place.second), value});
        return target;
    }

  private:
    [[nodiscard]] std::vector<Place> places_of(const std::vector<LoadCase::Support>& entries) const {
        LoadCase picked;
        picked.name = "stage";
        picked.supports = entries;
        std::vector<Place> places;
        for (const mechanics::Support& support : resolve(picked, surface_).supports) {
            for (int d = 0; d < mechanics::kDofsPerNode; ++d)
                if (support.fixed.contains[d]) places.emplace_back(support.node.value, d);
        }
        return places;
    }

    [[nodiscard]] mechanics::NodeValues loads() const {
        mechanics::NodeValues sum =
            mechanics::NodeValues::Zero(static_cast<Eigen::Index>(nodes_), mechanics::kDofsPerNode);
        for (const auto& [name, factor] : factors_) {
            LoadCase part = case_of(name);
            part.supports.clear();
            part.prescribed.clear();
            sum += factor * load_rows(resolve(part, surface_), nodes_);
        }
        return sum;
    }

    [[nodiscard]] LoadCase case_of(const std::string& name) const {
        if (name == load_case_.name) return load_case_;
        return combined(load_case_of(name, cases_), cases_);
    }

    const Surface& surface_;
    const LoadCase& load_case_;
    std::span<const LoadCase> cases_;
    std::size_t nodes_;
    std::vector<mechanics::Support> supports_;
    std::map<Place, double> held_;
    std::map<std::string, double> factors_;
};

/// The load cases that stages name, as files, in the order of their names.
std::vector<std::string> named_cases(std::span<const Stage> stages, std::span<const LoadCase> cases,
                                     const LoadCase& own) {
    std::map<std::string, std::string> texts;
    for (const Stage& stage : stages) {
        for (const LoadCase::Share& share : stage.loads) {
            const bool is_own = share.load_case == own.name;
            texts[share.load_case] =
                load_case_text(is_own ? own : combined(load_case_of(share.load_case, cases), cases));
        }
    }
    std::vector<std::string> result;
    for (const auto& [name, text] : texts) result.push_back(text);
    return result;
}

Json stage_json(const Stage& stage) {
    Json json = {{"name", stage.name}};
    for (const LoadCase::Share& share : stage.loads)
        json["loads"].push_back({{"load_case", share.load_case}, {"factor", share.factor}});
    const auto lists = [](const std::vector<LoadCase::Support>& supports,
                          const std::vector<LoadCase::PrescribedDisplacement>& prescribed) {
        LoadCase holder;
        holder.name = "stage";
        holder.supports = supports;
        holder.prescribed = prescribed;
        return load_case_json(holder);
    };
    if (!stage.prescribed.empty()) json["prescribed"] = lists({}, stage.prescribed).at("prescribed");
    if (!stage.keep.empty()) json["keep"] = lists(stage.keep, {}).at("supports");
    if (!stage.free.empty()) json["free"] = lists(stage.free, {}).at("supports");
    return json;
}

struct JoinedAssembly {
    mechanics::Assembly assembly;
    std::vector<detail::TileStart> starts;
};

JoinedAssembly assembly_of(const Surface& surface, const SimulationOptions& options,
                           const base::Control& control) {
    const auto tiles = detail::TileBuilder().build_all(surface, model_choice(options),
                                                       {.threads = options.threads, .control = control});
    detail::JoinedTiles joined = detail::join_tiles(surface, tiles, control);
    return {reduction::assemble(joined.parts, control), std::move(joined.starts)};
}

}  // namespace

std::vector<Stage> parse_stages(std::string_view text, const std::string& source) {
    const JsonReader json = JsonReader::from_text(text, source);
    json.expect_format("stages");
    json.allow_only({"format", "stages"});
    std::vector<Stage> stages;
    for (const JsonReader& stage : json.at("stages").elements()) stages.push_back(read_stage(stage));
    if (stages.empty()) json.at("stages").fail("is empty, where at least one stage is needed");
    return stages;
}

std::string stages_text(std::span<const Stage> stages) {
    Json json = {{"format", "fretwork/stages/1"}, {"stages", Json::array()}};
    for (const Stage& stage : stages) json["stages"].push_back(stage_json(stage));
    return base::json_text(json);
}

std::vector<Stage> read_stages(const std::filesystem::path& path) {
    return parse_stages(base::read_text_file(path), path.string());
}

SurfaceResult simulate_stages(const Surface& surface, const StagePlan& plan, const SimulationOptions& options,
                              const base::Control& control) {
    options.validate(surface);
    if (plan.stages.empty()) throw base::InputError("there is no stage to simulate");
    if (!is_nonlinear(surface, options) || mixed_share(options.model) || options.load_steps > 1 ||
        options.estimate_error || options.estimate_model_error)
        throw base::InputError(
            "stages are followed by full and corotational tiles, without load steps and estimates of errors");
    const auto started = std::chrono::steady_clock::now();
    const auto [assembly, starts] = assembly_of(surface, options, control);
    const auto interface_count = static_cast<int>(surface.tessellation.interface_nodes.size());
    SurfaceResult result;
    for (int i = 0; i < assembly.reported_nodes; ++i)
        result.nodes.push_back({i, assembly.nodes[i], i < interface_count});
    Stages state(surface, plan.supports, plan.cases, assembly.nodes.size());
    mechanics::StagedPath path(assembly,
                               {.branch = options.branch, .threads = options.threads, .control = control});
    mechanics::NodeValues displacements =
        mechanics::NodeValues::Zero(assembly.reported_nodes, mechanics::kDofsPerNode);
    for (const Stage& stage : plan.stages) {
        result.load_steps.push_back(path.advance(state.target(stage, displacements)));
        if (!result.load_steps.back().converged()) break;
        displacements = result.load_steps.back().displacements;
    }
    result.solution = result.load_steps.back();
    result.solver = "newton";
    if (options.estimate_where_doubtful && result.solution.converged() && !is_reference(surface, options))
        result.model_doubt = model_doubt(detail::tile_deformations(assembly, starts, result.solution));
    result.subject = result_subject(surface, plan.supports, options);
    result.subject->stages_text = stages_text(plan.stages);
    result.subject->stage_load_cases = named_cases(plan.stages, plan.cases, plan.supports);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    detail::add_wanted(surface, plan.supports, options, control, result);
    return result;
}

}  // namespace fretwork::simulation
