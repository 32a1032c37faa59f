// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/promises.hpp"
#include "fuzz/readers.hpp"
#include "tools/report_files.hpp"

#include <fretwork/base/json_reader.hpp>
#include <fretwork/design/target/target_file.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/results/result_file.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/reduction/scenarios/scenario.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/results/result_subject.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/stages.hpp>
#include <fretwork/tiling/painting/painting.hpp>
#include <studio/document/autosave.hpp>

namespace fretwork::fuzz {

void read_autosave(std::string_view bytes) {
    (void)studio::parse_autosave(bytes, "input");
}

void read_beams(std::string_view bytes) {
    app::check_beam_table(std::string(bytes), "input");
}

void read_facts(std::string_view bytes) {
    app::check_facts(std::string(bytes), "input");
}

void read_frame(std::string_view bytes) {
    promise_round_trip(
        bytes, [](std::string_view text) { return mechanics::parse_frame(text, "input"); },
        mechanics::frame_text);
}

void read_layout(std::string_view bytes) {
    promise_round_trip(
        bytes, [](std::string_view text) { return pattern::parse_node_layout(text, "input"); },
        pattern::node_layout_text);
}

void read_load_case(std::string_view bytes) {
    promise_round_trip(
        bytes, [](std::string_view text) { return simulation::parse_load_case(text, "input"); },
        simulation::load_case_text);
}

void read_painting(std::string_view bytes) {
    static const pattern::NodeLayout layout = pattern::find_node_layout("paper7");
    promise_round_trip(
        bytes, [](std::string_view text) { return tiling::parse_painting(text, "input", layout); },
        [](const tiling::Painting& painting) { return tiling::painting_text(painting, layout); });
}

void read_project(std::string_view bytes) {
    promise_round_trip(
        bytes, [](std::string_view text) { return simulation::parse_project(text, "input"); },
        simulation::project_text);
}

/// Results of surfaces say of what they are; those of frames do not.
void read_result(std::string_view bytes) {
    const auto surface = [](std::string_view text) {
        return simulation::parse_surface_result(text, "input");
    };
    if (base::JsonReader::from_text(bytes, "input").find("subject")) {
        simulation::check_subject(*surface(bytes).subject, "input");
        promise_round_trip(bytes, surface, simulation::surface_result_text);
    } else {
        promise_round_trip(
            bytes, [](std::string_view text) { return mechanics::parse_result(text, "input"); },
            mechanics::result_text);
    }
}

void read_scenario(std::string_view bytes) {
    promise_round_trip(
        bytes, [](std::string_view text) { return reduction::parse_scenario(text, "input"); },
        reduction::scenario_text);
}

void read_setting(std::string_view bytes) {
    promise_round_trip(
        bytes, [](std::string_view text) { return reduction::parse_setting(text, "input"); },
        reduction::setting_text);
}

void read_stages(std::string_view bytes) {
    (void)simulation::parse_stages(bytes, "input");
}

void read_target(std::string_view bytes) {
    promise_round_trip(
        bytes, [](std::string_view text) { return design::parse_target(text, "input"); },
        design::target_text);
}

}  // namespace fretwork::fuzz
