// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/fan_graph.hpp>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <iterator>
#include <set>

namespace fretwork::pattern::detail {
namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                    boost::property<boost::edge_index_t, std::size_t>>;

/// The fan's beams, numbered as in Fan::edges; its nodes keep their numbers.
Graph beam_graph(const Fan& fan) {
    Graph graph(fan.nodes.size());
    for (std::size_t i = 0; i < fan.edges.size(); ++i) {
        boost::add_edge(fan.edges[i][0], fan.edges[i][1], i, graph);
    }
    return graph;
}

/// The beams, followed by the edges of the outside; a hub is one more vertex.
Graph graph_with_outside(const Fan& fan, Outside outside) {
    Graph graph = beam_graph(fan);
    const std::size_t count = fan.interface_node_count;
    std::size_t number = fan.edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t other = outside == Outside::Hub ? fan.nodes.size() : (i + 1) % count;
        boost::add_edge(i, other, number++, graph);
    }
    return graph;
}

/// The block (biconnected component) of every edge, by edge number.
std::vector<std::size_t> blocks(const Graph& graph) {
    std::vector<std::size_t> block(boost::num_edges(graph));
    const auto map = boost::make_iterator_property_map(block.begin(), boost::get(boost::edge_index, graph));
    boost::biconnected_components(graph, map);
    return block;
}

}  // namespace

FanComponents fan_components(const Fan& fan) {
    const Graph graph = beam_graph(fan);
    FanComponents components{0, std::vector<int>(fan.nodes.size())};
    boost::connected_components(graph, components.of_node.data());
    std::set<int> used;
    for (std::size_t i = 0; i < fan.nodes.size(); ++i) {
        if (boost::degree(i, graph) == 0)
            components.of_node[i] = -1;
        else
            used.insert(components.of_node[i]);
    }
    components.count = static_cast<int>(used.size());
    return components;
}

std::vector<FanNodeIndex> articulation_nodes(const Fan& fan, Outside outside) {
    std::vector<std::size_t> points;
    boost::articulation_points(graph_with_outside(fan, outside), std::back_inserter(points));
    std::vector<FanNodeIndex> nodes;
    for (const std::size_t point : points) {
        if (point < fan.nodes.size()) nodes.emplace_back(point);
    }
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

std::vector<std::size_t> dangling_beams(const Fan& fan) {
    const std::vector<std::size_t> block = blocks(graph_with_outside(fan, Outside::Ring));
    const std::size_t bearing = block[fan.edges.size()];
    std::vector<std::size_t> beams;
    for (std::size_t i = 0; i < fan.edges.size(); ++i) {
        if (block[i] != bearing) beams.push_back(i);
    }
    return beams;
}

}  // namespace fretwork::pattern::detail
