// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/internal/layout_json.hpp>
#include <studio/document/json_lists.hpp>
#include <studio/layouts/layout_json.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace fretwork::studio {
namespace {

using base::Json;
using base::JsonReader;
using pattern::LayoutNodeIndex;
using pattern::NodeLayout;
using pattern::Region;

/// The kinds of nodes, as messages name them. A radial node is added on the left side, its partner with it.
constexpr std::pair<std::string_view, Region> kKinds[] = {{"center", Region::Center},
                                                          {"radial", Region::LeftRadial},
                                                          {"radial", Region::RightRadial},
                                                          {"face", Region::Face},
                                                          {"interface", Region::Interface}};

std::string_view kind_of(Region region) {
    for (const auto& [kind, its_region] : kKinds) {
        if (its_region == region) return kind;
    }
    return "corner";  // no layout has any
}

Json node_json(const NodeLayout& layout, LayoutNodeIndex index) {
    const pattern::LayoutNode& node = layout.nodes()[index];
    Json place = Json::array();
    Json exact = Json::array();
    for (const pattern::Rational& coordinate : node.place) {
        place.push_back(coordinate.to_double());
        exact.push_back(coordinate.text());
    }
    return {{"kind", kind_of(node.region)},
            {"place", place},
            {"exact", exact},
            {"twins", numbers_json(twins_of(layout, index))}};
}

Region read_region(const JsonReader& json) {
    const std::string name = json.string();
    for (const auto& [kind, region] : kKinds) {
        if (kind == name) return region;
    }
    json.fail("must be one of center, radial, face, interface");
}

LayoutChange::Place read_place(const JsonReader& json) {
    const std::vector<double> numbers = json.numbers(3);
    constexpr double kFarAway = 1e3;  // far beside the triangle
    if (!std::ranges::all_of(numbers, [](double one) { return std::abs(one) <= kFarAway; }))
        json.fail("must have three barycentric coordinates from -1000 to 1000");
    return {numbers[0], numbers[1], numbers[2]};
}

LayoutNodeIndex read_node(const JsonReader& json, const NodeLayout& layout) {
    return LayoutNodeIndex(
        static_cast<int>(json.integer(0, static_cast<long long>(layout.nodes().size()) - 1)));
}

}  // namespace

Json layout_json(const NodeLayout& layout) {
    Json nodes = Json::array();
    for (std::size_t i = 0; i < layout.nodes().size(); ++i)
        nodes.push_back(node_json(layout, LayoutNodeIndex(i)));
    Json edges = Json::array();
    for (const pattern::Edge& edge : layout.candidate_edges())
        edges.push_back({edge.first.value, edge.second.value});
    return {{"layout", pattern::node_layout_json(layout)}, {"nodes", nodes}, {"edges", edges}};
}

LayoutHand read_hand(const JsonReader& request) {
    constexpr long long kFewestSteps = 4;
    LayoutHand hand;
    if (const auto grid = request.find("grid"))
        hand.steps = grid->integer(kFewestSteps, LayoutHand::kMostSteps);
    if (const auto mirror = request.find("mirror")) hand.keeps_mirror = mirror->boolean();
    return hand;
}

LayoutChange read_change(const JsonReader& json, const NodeLayout& layout) {
    json.allow_only({"move", "add", "remove", "to"});
    LayoutChange change;
    if (const auto to = json.find("to")) change.to = read_place(*to);
    if (const auto removed = json.find("remove")) {
        json.allow_only({"remove"});
        change.kind = LayoutChange::Kind::Remove;
        change.node = read_node(*removed, layout);
    } else if (const auto added = json.find("add")) {
        json.allow_only({"add", "to"});
        change.kind = LayoutChange::Kind::Add;
        change.region = read_region(*added);
    } else {
        change.node = read_node(json.at("move"), layout);
        (void)json.at("to");
    }
    return change;
}

Json count_json(const NodeLayout& layout, const CountedPatterns& counted) {
    Json samples = Json::array();
    for (const pattern::Pattern& pattern : counted.samples)
        samples.push_back(pattern::pattern_id(layout, pattern));
    return {{"patterns", counted.patterns}, {"complete", counted.is_complete}, {"samples", samples}};
}

}  // namespace fretwork::studio
