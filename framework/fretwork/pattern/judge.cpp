// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/fan_graph.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>

#include <algorithm>
#include <numeric>
#include <set>

namespace fretwork::pattern {
namespace {

std::string edge_name(const NodeLayout& layout, EdgeIndex edge) {
    Pattern::Bits bits;
    bits.set(edge);
    return pattern_id(layout, Pattern(bits));
}

/// The candidate edges whose copies are the given beams of a fan.
std::vector<EdgeIndex> edges_of_beams(const NodeLayout& layout, const Pattern& pattern,
                                      const std::set<std::array<FanNodeIndex, 2>>& beams, const Fan& fan) {
    std::vector<EdgeIndex> found;
    for (const EdgeIndex edge : pattern.edges()) {
        Pattern::Bits alone;
        alone.set(edge);
        const Fan copies = make_fan(layout, Pattern(alone), fan.sides);
        const auto in_fan = [&](FanNodeIndex node) {
            const auto place = std::find(fan.nodes.begin(), fan.nodes.end(), copies.nodes[node]);
            return FanNodeIndex(place - fan.nodes.begin());
        };
        const bool is_guilty = std::any_of(copies.edges.begin(), copies.edges.end(), [&](const auto& beam) {
            const std::array ends{in_fan(beam[0]), in_fan(beam[1])};
            return beams.contains({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
        });
        if (is_guilty) found.push_back(edge);
    }
    return found;
}

/// The verdict of one filter on one pattern, with one function for each form of rule.
class Judge {
  public:
    Judge(const NodeLayout& layout, const Filter& filter, const Pattern& pattern)
        : layout_(layout), filter_(filter), pattern_(pattern) {}

    Verdict operator()(const ConflictRule& rule) const {
        for (const EdgeIndex edge : pattern_.edges()) {
            const Pattern others(rule.conflicts[edge] & pattern_.bits());
            if (others.edge_count() == 0) continue;
            const EdgeIndex other = others.edges().back();
            if (other == edge)
                return rejected("the edge " + edge_name(layout_, edge) + " " + rule.self_phrase, {edge});
            return rejected("the edges " + edge_name(layout_, edge) + " and " + edge_name(layout_, other) +
                                " " + rule.phrase,
                            {edge, other});
        }
        return {};
    }

    Verdict operator()(const CapacityRule& rule) const {
        for (const CapacityRule::Resource& resource : rule.resources) {
            int load = 0;
            std::vector<EdgeIndex> bearing;
            for (const EdgeIndex edge : pattern_.edges()) {
                const int share = resource.loads[edge];
                load += share;
                if (share > 0) bearing.push_back(edge);
            }
            if (load > rule.limit)
                return rejected(resource.name + " has " + rule.phrase + " " + std::to_string(load) +
                                    ", above " + std::to_string(rule.limit),
                                std::move(bearing));
        }
        return {};
    }

    Verdict operator()(const CoverRule& rule) const {
        for (const EdgeGroup& group : rule.groups) {
            if ((group.edges & pattern_.bits()).none()) return rejected(rule.phrase + " " + group.name, {});
        }
        return {};
    }

    Verdict operator()(const GraphRule& rule) const {
        const Fan fan = make_fan(layout_, pattern_, kReferenceSides);
        return rule.property == GraphRule::Property::Connected ? judge_components(fan)
                                                               : judge_articulation(fan);
    }

    Verdict operator()(const PredicateRule& rule) const {
        return rule.is_kept(pattern_) ? Verdict{} : rejected(rule.phrase, pattern_.edges());
    }

  private:
    [[nodiscard]] Verdict rejected(std::string reason, std::vector<EdgeIndex> guilty) const {
        return {false, filter_.name, std::move(reason), std::move(guilty)};
    }

    /// The beams in the component of the fan's first beam are not guilty; all other beams are. The first
    /// beam begins at the first used interface node, if there is one.
    [[nodiscard]] Verdict judge_components(const Fan& fan) const {
        const detail::FanComponents components = detail::fan_components(fan);
        if (components.count <= 1) return {};
        const auto of_edge = [&](const auto& edge) { return components.of_node[edge[0]]; };
        std::set<std::array<FanNodeIndex, 2>> apart;
        for (const auto& edge : fan.edges) {
            if (of_edge(edge) != of_edge(fan.edges.front())) apart.insert(edge);
        }
        return rejected("the fan falls into " + std::to_string(components.count) + " components",
                        edges_of_beams(layout_, pattern_, apart, fan));
    }

    [[nodiscard]] Verdict judge_articulation(const Fan& fan) const {
        const std::vector<FanNodeIndex> points = detail::articulation_nodes(fan);
        if (points.empty()) return {};
        std::set<std::array<FanNodeIndex, 2>> dangling;
        for (const std::size_t beam : detail::dangling_beams(fan)) dangling.insert(fan.edges[beam]);
        const LayoutNodeIndex node = fan.nodes[points.front()].layout_node;
        return rejected("a part hangs on node n" + std::to_string(node.value) + " alone",
                        edges_of_beams(layout_, pattern_, dangling, fan));
    }

    const NodeLayout& layout_;
    const Filter& filter_;
    const Pattern& pattern_;
};

}  // namespace

Verdict judge(const NodeLayout& layout, const Filter& filter, const Pattern& pattern) {
    return std::visit(Judge(layout, filter, pattern), filter.rule);
}

Verdict judge(const NodeLayout& layout, std::span<const Filter> filters, const Pattern& pattern) {
    for (const Filter& filter : filters) {
        if (Verdict verdict = judge(layout, filter, pattern); !verdict.accepted) return verdict;
    }
    return {};
}

}  // namespace fretwork::pattern
