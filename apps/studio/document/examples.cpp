// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/studio/detail/embedded_examples.hpp>
#include <studio/document/examples.hpp>

#include <typed/painting_text.hpp>

namespace fretwork::studio {
namespace {

using base::JsonReader;

/// An example's file: what `fretwork tile` takes, and a load case.
JsonReader read_example(std::string_view name) {
    const auto name_of = [](const auto& file) { return file.first; };
    const auto& file = base::find_named(name, embedded_examples, name_of, "example");
    return JsonReader::from_text(file.second, "example " + std::string(name));
}

}  // namespace

const std::vector<Example>& examples() {
    static const std::vector<Example> all = [] {
        std::vector<Example> list;
        for (const auto& [name, text] : embedded_examples) {
            const JsonReader json = read_example(name);
            list.push_back({std::string(name), json.at("title").string(), json.at("description").string()});
        }
        return list;
    }();
    return all;
}

std::string example_title(std::string_view name) {
    return read_example(name).at("title").string();
}

simulation::Project make_example(std::string_view name, const base::Control& control) {
    const JsonReader json = read_example(name);
    json.allow_only({"title", "description", "outline", "tile_size", "patterns", "palette", "load_case"});
    const outlines::Outline outline = outlines::parse_outline(json.at("outline").text(), json.source());
    const simulation::NewProjectOptions options{
        .edge_length = json.at("tile_size").positive_number(),
        .painting = typed::read_painting(
            {.patterns = json.at("patterns").string(), .palette = json.at("palette").string()}),
        .control = control};
    simulation::Project project = simulation::make_project(outline, options, nullptr).project;
    project.load_cases.push_back(simulation::read_load_case(json.at("load_case")));
    simulation::check_selections(project.load_cases.front(), project.tessellation);
    return project;
}

}  // namespace fretwork::studio
