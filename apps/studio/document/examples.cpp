// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/studio/detail/embedded_examples.hpp>
#include <studio/document/examples.hpp>

#include <algorithm>
#include <typed/painting_text.hpp>

namespace fretwork::studio {
namespace {

using base::JsonReader;

/// An example's file: what `fretwork tile` takes, and a load case.
JsonReader read_example(std::string_view name) {
    const auto row = std::ranges::find(embedded_examples, name, [](const auto& file) { return file.first; });
    if (row != embedded_examples.end())
        return JsonReader::from_text(row->second, "example " + std::string(name));
    std::vector<std::string> names;
    for (const auto& [known, text] : embedded_examples) names.emplace_back(known);
    throw base::InputError(base::unknown_name_message("example", name, names));
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
