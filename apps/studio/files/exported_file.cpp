// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <studio/files/exported_file.hpp>
#include <studio/server/words.hpp>
#include <studio/solving/making_doubts.hpp>
#include <studio/solving/synced_session.hpp>

#include <algorithm>
#include <typed/making_choice.hpp>
#include <typed/picture_options.hpp>
#include <utility>

namespace fretwork::studio {
namespace {

/// The part of an address that says how a scene is drawn: as the options of `fretwork export`.
void read_drawing(const Target& target, exports::Scene& scene) {
    if (const std::string scale = target.value("scale"); !scale.empty())
        scene.displacement_scale = typed::parse_scale(scale);
    if (const std::string view = target.value("view"); !view.empty()) scene.view = typed::parse_view(view);
    if (const std::string size = target.value("size"); !size.empty())
        scene.picture.size = typed::parse_size(size);
    if (const std::string colour = target.value("colour"); !colour.empty()) scene.picture.colour = colour;
}

/// The part of an address that says how a surface is made.
exports::Making read_making(const Target& target, const std::optional<simulation::Conditions>& conditions) {
    const typed::MakingChoice choice{.fillet = target.value("fillet"),
                                     .kerf = target.value("kerf"),
                                     .frame = target.value("frame"),
                                     .bolts = target.value("bolts"),
                                     .eye = target.value("eye"),
                                     .bed = target.value("bed"),
                                     .fit = target.value("fit"),
                                     .clearance = target.value("clearance"),
                                     .layer = target.value("layer"),
                                     .prefix = ""};
    return typed::read_making(choice, conditions ? &*conditions : nullptr);
}

constexpr std::string_view kExportKeys[] = {"token",  "to",     "content",   "scale", "view",  "size",
                                            "colour", "fillet", "kerf",      "frame", "bolts", "eye",
                                            "bed",    "fit",    "clearance", "layer", "steps"};

void check_keys(const Target& target) {
    for (const auto& [name, value] : target.values) {
        if (std::ranges::find(kExportKeys, name) != std::end(kExportKeys)) continue;
        const std::vector<std::string> known(std::begin(kExportKeys) + 1, std::end(kExportKeys));
        throw base::InputError(
            base::unknown_name_message("key of /export", base::shortened(name, 40), known));
    }
}

const exports::WriterRow& find_target_writer(const Target& target) {
    const std::string content = target.value("content");
    const auto wanted = content.empty() ? std::nullopt : std::optional(exports::parse_content(content));
    return exports::find_writer(target.value("to"), wanted);
}

/// The load path of a nonlinear model, in the number of steps that is asked for. The path of a linear one is
/// straight, and its end is enough.
void add_load_path(const Target& target, simulation::SimulationOptions options, exports::Scene& scene) {
    constexpr long long kMostSteps = 200;
    const std::string text = target.value("steps");
    if (text.empty() || scene.results.empty()) return;
    const auto steps = base::read_number<long long>(text);
    if (!steps || *steps < 2 || *steps > kMostSteps)
        throw base::InputError("steps", "", base::shortened(text, 40) + " is not a number from 2 to 200");
    if (!simulation::is_nonlinear(scene.surface, options)) return;
    options.load_steps = static_cast<int>(*steps);
    scene.results.front().result.load_steps =
        simulation::simulate(scene.surface, *scene.load_case, options, scene.control).load_steps;
}

/// A file as `fretwork export` writes it, with its remarks. `solved` may be null.
HttpAnswer exported(const Target& target, const Situation& situation, const SolvedPtr& solved,
                    const base::Control& control) {
    const exports::WriterRow& writer = find_target_writer(target);
    const State& state = *situation.state;
    exports::Scene scene{open_surface(state).surface};
    scene.control = control;
    read_drawing(target, scene);
    const simulation::SimulationOptions options{
        .model = *state.model, .analysis = state.analysis, .threads = 1};
    if (!state.load_cases->empty()) {
        const simulation::LoadCase load_case = load_case_of(situation);
        scene.conditions = simulation::resolve(load_case, scene.surface);
        scene.load_case = load_case;
        if (solved) {
            scene.results.push_back({solved->model, solved->result});
            scene.results.front().result.subject =
                simulation::result_subject(scene.surface, load_case, options, solved->full_tiles);
        }
    }
    if (writer.moves()) add_load_path(target, options, scene);
    if (writer.is_made()) scene.making = read_making(target, scene.conditions);
    exports::Written written = writer.write(scene);
    if (writer.is_made()) {
        for (const std::string& doubt :
             making_doubts(scene.surface, scene.making.shape, scene.making.facts.clearance).words)
            written.remarks.push_back(doubt);
    }
    return {.type = "application/octet-stream",
            .body = std::move(written.text),
            .download_name = target.value("to"),
            .remark = base::printable(base::join(written.remarks, "; "))};
}

}  // namespace

HttpAnswer refused(unsigned status, const std::string& why) {
    return {.status = status, .body = one_line(why) + "\n"};
}

ExportTarget::ExportTarget(Target target) : target_(std::move(target)) {
    check_keys(target_);
    if (!is_project()) (void)find_target_writer(target_);
}

bool ExportTarget::is_project() const {
    return target_.value("to") == "project.json";
}

bool ExportTarget::shows_answer() const {
    if (is_project()) return false;
    return find_target_writer(target_).shows_results();
}

HttpAnswer ExportTarget::file_of(const Situation& situation, const std::filesystem::path& folder,
                                 const SolvedPtr& solved, const base::Control& control) const {
    if (!is_project()) return exported(target_, situation, solved, control);
    return {.type = "application/json",
            .body = simulation::project_text(make_project(*situation.state, folder)),
            .download_name = target_.value("to")};
}

}  // namespace fretwork::studio
