// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/detail/embedded_layouts.hpp>
#include <fretwork/pattern/detail/exact_geometry.hpp>
#include <fretwork/pattern/detail/layout_rules.hpp>
#include <fretwork/pattern/internal/layout_json.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <algorithm>
#include <system_error>
#include <utility>

namespace fretwork::pattern {
namespace {

using base::JsonReader;

std::vector<LayoutNode> make_nodes(const NodeLayoutDescription& description) {
    const Rational zero(0);
    const Rational one(1);
    std::vector<LayoutNode> nodes;
    if (description.center) nodes.push_back({Region::Center, {one, zero, zero}});
    for (const Rational& share : description.radial)
        nodes.push_back({Region::LeftRadial, {one - share, share, zero}});
    for (const Rational& share : description.radial)
        nodes.push_back({Region::RightRadial, {one - share, zero, share}});
    for (const auto& place : description.face) nodes.push_back({Region::Face, place});
    for (const Rational& share : description.interface)
        nodes.push_back({Region::Interface, {zero, one - share, share}});
    return nodes;
}

bool lies_along_left_out_side(const LayoutNode& first, const LayoutNode& second) {
    const auto on_right_side = [](const LayoutNode& node) { return node.place[1] == Rational(0); };
    const auto on_interface_side = [](const LayoutNode& node) { return node.place[0] == Rational(0); };
    return (on_right_side(first) && on_right_side(second)) ||
           (on_interface_side(first) && on_interface_side(second));
}

bool passes_through_a_node(const std::vector<detail::ExactPoint>& points, std::size_t i, std::size_t j) {
    return std::any_of(points.begin(), points.end(), [&](const detail::ExactPoint& point) {
        return detail::is_strictly_between(point, points[i], points[j]);
    });
}

std::vector<Edge> make_candidate_edges(const std::vector<LayoutNode>& nodes) {
    std::vector<detail::ExactPoint> points;
    for (const LayoutNode& node : nodes) points.push_back(detail::exact_point(node));
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (std::size_t j = i + 1; j < nodes.size(); ++j) {
            if (lies_along_left_out_side(nodes[i], nodes[j]) || passes_through_a_node(points, i, j)) continue;
            edges.push_back({LayoutNodeIndex(i), LayoutNodeIndex(j)});
        }
    }
    return edges;
}

// ---- layout files ----

Rational read_rational(const JsonReader& json) {
    const std::string text = json.string();
    return json.located([&] { return parse_rational(text); });
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

base::Json write_shares(std::span<const Rational> shares) {
    base::Json json = base::Json::array();
    for (const Rational& share : shares) json.push_back(share.text());
    return json;
}

}  // namespace

NodeLayout::NodeLayout(NodeLayoutDescription description) : description_(std::move(description)) {
    const std::string source = "layout '" + description_.name + "'";
    if (const auto fault = detail::find_layout_fault(description_))
        throw base::InputError(source, fault->pointer, fault->message);
    nodes_ = make_nodes(description_);
    edges_ = make_candidate_edges(nodes_);
    if (edges_.empty() || edges_.size() > static_cast<std::size_t>(kMaxCandidateEdges)) {
        throw base::InputError(source + ": its " + std::to_string(nodes_.size()) + " nodes give " +
                               std::to_string(edges_.size()) + " candidate edges, where 1 to " +
                               std::to_string(kMaxCandidateEdges) + " are possible");
    }
}

std::vector<LayoutNodeIndex> NodeLayout::interface_nodes() const {
    std::vector<LayoutNodeIndex> found;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].region == Region::Interface) found.emplace_back(i);
    }
    return found;
}

LayoutNodeIndex NodeLayout::left_partner(LayoutNodeIndex node) const {
    const bool is_right = nodes_[node].region == Region::RightRadial;
    return is_right ? LayoutNodeIndex(node.value - static_cast<int>(description_.radial.size())) : node;
}

NodeLayout read_node_layout(const JsonReader& json) {
    NodeLayoutDescription description = read_description(json);
    if (const auto fault = detail::find_layout_fault(description))
        throw base::InputError(json.source(), json.pointer() + fault->pointer, fault->message);
    return json.located([&] { return NodeLayout(std::move(description)); });
}

NodeLayout read_node_layout(const std::filesystem::path& path) {
    return read_node_layout(JsonReader::from_file(path));
}

NodeLayout parse_node_layout(std::string_view text, std::string source) {
    return read_node_layout(JsonReader::from_text(text, std::move(source)));
}

base::Json node_layout_json(const NodeLayout& layout) {
    const NodeLayoutDescription& description = layout.description();
    base::Json json = {{"format", "fretwork/layout/1"},
                       {"name", description.name},
                       {"center", description.center},
                       {"corners", description.corners},
                       {"radial", write_shares(description.radial)},
                       {"face", base::Json::array()},
                       {"interface", write_shares(description.interface)}};
    for (const auto& place : description.face) json["face"].push_back(write_shares(place));
    return json;
}

std::string node_layout_text(const NodeLayout& layout) {
    return base::json_text(node_layout_json(layout));
}

std::vector<std::string> layout_names() {
    return base::names_of(embedded_layouts, [](const auto& layout) { return layout.first; });
}

bool is_layout_name(std::string_view name) {
    return std::ranges::any_of(embedded_layouts, [&](const auto& layout) { return layout.first == name; });
}

const NodeLayout& paper_layout() {
    static const NodeLayout layout = find_node_layout("paper7");
    return layout;
}

NodeLayout find_node_layout(std::string_view name_or_path) {
    for (const auto& [name, text] : embedded_layouts) {
        if (name == name_or_path) return read_node_layout(JsonReader::from_text(text, std::string(name)));
    }
    const std::filesystem::path path(name_or_path);
    std::error_code ignored;  // set if no file can have this name
    if (path.has_parent_path() || path.has_extension() || std::filesystem::exists(path, ignored))
        return read_node_layout(path);
    throw base::InputError(base::unknown_name_message("layout", name_or_path, layout_names()) +
                           "; the file of a layout of your own ends in .json");
}

}  // namespace fretwork::pattern
