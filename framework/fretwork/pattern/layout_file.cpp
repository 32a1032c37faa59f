// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/detail/json_text.hpp>
#include <fretwork/base/error.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/detail/embedded_layouts.hpp>
#include <fretwork/pattern/detail/layout_rules.hpp>
#include <fretwork/pattern/node_layout.hpp>

#include <algorithm>

namespace fretwork::pattern {
namespace {

using base::JsonReader;

Rational read_rational(const JsonReader& json) {
    const std::string text = json.string();
    try {
        return parse_rational(text);
    } catch (const base::InputError& error) {
        json.fail(error.what());
    }
}

std::vector<Rational> read_shares(const std::optional<JsonReader>& json) {
    std::vector<Rational> shares;
    if (!json) return shares;
    for (const JsonReader& element : json->elements()) shares.push_back(read_rational(element));
    return shares;
}

std::array<Rational, 3> read_place(const JsonReader& json) {
    const std::vector<JsonReader> coordinates = json.elements(3);
    return {read_rational(coordinates[0]), read_rational(coordinates[1]), read_rational(coordinates[2])};
}

NodeLayoutDescription read_description(const JsonReader& json) {
    json.expect_format("layout");
    json.allow_only({"format", "name", "center", "corners", "radial", "face", "interface"});
    NodeLayoutDescription description;
    description.name = json.at("name").string();
    if (const auto center = json.find("center")) description.center = center->boolean();
    if (const auto corners = json.find("corners")) description.corners = corners->boolean();
    description.radial = read_shares(json.find("radial"));
    if (const auto face = json.find("face")) {
        for (const JsonReader& place : face->elements()) description.face.push_back(read_place(place));
    }
    description.interface = read_shares(json.at("interface"));
    return description;
}

NodeLayout read_layout(const JsonReader& json) {
    NodeLayoutDescription description = read_description(json);
    if (const auto fault = detail::find_layout_fault(description))
        throw base::InputError(json.source(), fault->pointer, fault->message);
    return NodeLayout(std::move(description));
}

base::detail::Json write_shares(std::span<const Rational> shares) {
    base::detail::Json json = base::detail::Json::array();
    for (const Rational& share : shares) json.push_back(share.text());
    return json;
}

}  // namespace

NodeLayout read_node_layout(const std::filesystem::path& path) {
    return read_layout(JsonReader::from_file(path));
}

NodeLayout parse_node_layout(std::string_view text, std::string source) {
    return read_layout(JsonReader::from_text(text, std::move(source)));
}

std::string node_layout_text(const NodeLayout& layout) {
    const NodeLayoutDescription& description = layout.description();
    base::detail::Json json = {{"format", "fretwork/layout/1"},
                               {"name", description.name},
                               {"center", description.center},
                               {"corners", description.corners},
                               {"radial", write_shares(description.radial)},
                               {"face", base::detail::Json::array()},
                               {"interface", write_shares(description.interface)}};
    for (const auto& place : description.face) json["face"].push_back(write_shares(place));
    return base::detail::json_text(json);
}

std::vector<std::string> layout_names() {
    std::vector<std::string> names;
    for (const auto& [name, text] : embedded_layouts) names.emplace_back(name);
    return names;
}

NodeLayout find_node_layout(std::string_view name_or_path) {
    for (const auto& [name, text] : embedded_layouts) {
        if (name == name_or_path) return read_layout(JsonReader::from_text(text, std::string(name)));
    }
    const std::filesystem::path path(name_or_path);
    if (path.has_parent_path() || path.has_extension() || std::filesystem::exists(path))
        return read_node_layout(path);
    throw base::InputError(base::unknown_name_message("layout", name_or_path, layout_names()) +
                           "; the file of a layout of your own ends in .json");
}

}  // namespace fretwork::pattern
