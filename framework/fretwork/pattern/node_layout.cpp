// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/pattern/detail/exact_geometry.hpp>
#include <fretwork/pattern/detail/layout_rules.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::pattern {
namespace {

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
    const bool is_right = nodes_[static_cast<std::size_t>(node)].region == Region::RightRadial;
    return is_right ? LayoutNodeIndex(node.value - static_cast<int>(description_.radial.size())) : node;
}

}  // namespace fretwork::pattern
