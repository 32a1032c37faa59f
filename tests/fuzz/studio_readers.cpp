// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/promises.hpp"
#include "fuzz/readers.hpp"
#include "simulation/honeycomb.hpp"

#include <fretwork/base/json_reader.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <studio/designing/design_request.hpp>
#include <studio/document/edits.hpp>
#include <studio/files/new_document.hpp>
#include <studio/server/access.hpp>

namespace fretwork::fuzz {
namespace {

/// The document that messages are about: six tiles with three patterns, and one load case.
const studio::StatePtr& document() {
    static const studio::StatePtr kDocument = [] {
        simulation::Project project = test::honeycomb(3, 2, {"0-1+1-6", "0-6", "0-1+1-5+1-6+5-6"});
        project.load_cases.push_back(test::cantilever({0.0, 0.0, -0.01}));
        project.setting = reduction::paper_setting();
        return std::make_shared<const studio::State>(studio::make_state(project, "/nowhere"));
    }();
    return kDocument;
}

}  // namespace

/// An edit is of the document, and what it makes of it can be saved and opened.
void read_edit(std::string_view bytes) {
    const auto request = base::JsonReader::from_text(bytes, "message");
    const auto edit = studio::edited(*document(), request.at("do").string(), request);
    if (!edit) return;
    promise_round_trip(
        simulation::project_text(studio::make_project(edit->state, "/nowhere")),
        [](std::string_view text) { return simulation::parse_project(text, "saved"); },
        simulation::project_text);
}

void read_design_request(std::string_view bytes) {
    (void)studio::read_design(base::JsonReader::from_text(bytes, "message"), {document(), 0});
}

/// A request for another document. Its drawing is read, and not tiled.
void read_new_request(std::string_view bytes) {
    const auto wanted = studio::read_new(base::JsonReader::from_text(bytes, "message"));
    if (wanted.example.empty()) (void)studio::take_outline(wanted.outline);
}

void read_web_target(std::string_view bytes) {
    const auto target = studio::parse_target(bytes);
    if (target) promise(target->path.starts_with('/'), "a path begins with a slash", bytes);
    (void)studio::is_own_host(bytes, "127.0.0.1");
    (void)studio::is_own_origin(bytes, "127.0.0.1");
}

}  // namespace fretwork::fuzz
