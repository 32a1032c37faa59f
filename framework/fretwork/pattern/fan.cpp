// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/nearly_convex.hpp>
#include <fretwork/pattern/fan.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace fretwork::pattern {
namespace {

/// The nodes and edges of a fan under construction.
class FanBuilder {
  public:
    FanBuilder(const NodeLayout& layout, int sides) : layout_(layout) {
        fan_.sides = sides;
        for (int t = 0; t < sides; ++t) {
            for (const LayoutNodeIndex node : layout.interface_nodes()) add_node({node, t});
        }
        fan_.interface_node_count = static_cast<int>(fan_.nodes.size());
    }

    void add_inner_nodes(const Pattern& pattern) {
        std::vector<Fan::Node> inner;
        for_each_copy(pattern, [&](const Fan::Node& first, const Fan::Node& second) {
            for (const Fan::Node& node : {first, second}) {
                if (!numbers_.contains(key(node))) inner.push_back(node);
            }
        });
        const auto before = [](const Fan::Node& a, const Fan::Node& b) { return key(a) < key(b); };
        std::sort(inner.begin(), inner.end(), before);
        inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
        for (const Fan::Node& node : inner) add_node(node);
    }

    void add_edges(const Pattern& pattern) {
        for_each_copy(pattern, [&](const Fan::Node& first, const Fan::Node& second) {
            const FanNodeIndex a = numbers_.at(key(first));
            const FanNodeIndex b = numbers_.at(key(second));
            fan_.edges.push_back({std::min(a, b), std::max(a, b)});
        });
        std::sort(fan_.edges.begin(), fan_.edges.end());
        fan_.edges.erase(std::unique(fan_.edges.begin(), fan_.edges.end()), fan_.edges.end());
    }

    Fan take() { return std::move(fan_); }

  private:
    static std::pair<int, int> key(const Fan::Node& node) { return {node.layout_node.value, node.sector}; }

    void add_node(const Fan::Node& node) {
        numbers_.emplace(key(node), FanNodeIndex(fan_.nodes.size()));
        fan_.nodes.push_back(node);
    }

    /// The unique name of a node of the fan, which may belong to several sectors.
    [[nodiscard]] Fan::Node canonical(LayoutNodeIndex node, int sector) const {
        switch (layout_.nodes()[node].region) {
            case Region::Center:
                return {node, 0};
            case Region::RightRadial:
                return {layout_.left_partner(node), (sector + 1) % fan_.sides};
            default:
                return {node, sector};
        }
    }

    template <class Visit>
    void for_each_copy(const Pattern& pattern, const Visit& visit) const {
        for (const EdgeIndex index : pattern.edges()) {
            const Edge& edge = layout_.candidate_edges()[index];
            for (int t = 0; t < fan_.sides; ++t) visit(canonical(edge.first, t), canonical(edge.second, t));
        }
    }

    const NodeLayout& layout_;
    Fan fan_;
    std::map<std::pair<int, int>, FanNodeIndex> numbers_;
};

geometry::Point2 barycentric_point(const std::array<Rational, 3>& place,
                                   const std::array<geometry::Point2, 3>& triangle) {
    geometry::Point2 point;
    for (std::size_t i = 0; i < 3; ++i) {
        point.x += place[i].to_double() * triangle[i].x;
        point.y += place[i].to_double() * triangle[i].y;
    }
    return point;
}

}  // namespace

Fan make_fan(const NodeLayout& layout, const Pattern& pattern, int sides) {
    if (sides < 3 || sides > geometry::kMostPolygonSides)
        throw base::InputError("a fan has 3 to " + std::to_string(geometry::kMostPolygonSides) +
                               " sectors, and " + std::to_string(sides) + " were wanted");
    FanBuilder builder(layout, sides);
    builder.add_inner_nodes(pattern);
    builder.add_edges(pattern);
    return builder.take();
}

base::IndexVector<FanNodeIndex, geometry::Point2> place_fan(const NodeLayout& layout, const Fan& fan,
                                                            const geometry::Polygon& polygon) {
    if (std::ssize(polygon) != fan.sides) {
        throw base::InputError("a fan of " + std::to_string(fan.sides) +
                               " sectors does not fit into a polygon of " + std::to_string(polygon.size()) +
                               " sides");
    }
    if (!geometry::is_nearly_convex(polygon))
        throw base::GeometryError("the polygon of a fan is not convex and counterclockwise" +
                                  geometry::inward_bend_text(polygon));
    const geometry::Point2 center = centroid(polygon);
    std::vector<geometry::Point2> places;
    places.reserve(fan.nodes.size());
    for (const Fan::Node& node : fan.nodes) {
        const std::array<geometry::Point2, 3> sector = {center, polygon[node.sector],
                                                        polygon[(node.sector + 1) % polygon.size()]};
        const LayoutNode& layout_node = layout.nodes()[node.layout_node];
        places.push_back(barycentric_point(layout_node.place, sector));
    }
    return places;
}

}  // namespace fretwork::pattern
