// SPDX-License-Identifier: GPL-3.0-or-later
// Node layouts, patterns, and their fans.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/pattern/mirror.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/pattern/pattern.hpp>

namespace fretwork::python {
namespace {

using namespace pattern;

void bind_layout(py::module_& m) {
    bind_enum<Region>(m);
    Record<LayoutNode>(m, "LayoutNode", "A node of the base triangle v0 v1 v2.")
        .constant("region", &LayoutNode::region, "Region")
        .constant("place", &LayoutNode::place,
                  "barycentric coordinates (v0, v1, v2) as Fractions, with sum 1")
        .done(Made::ByFunctions);
    py::class_<NodeLayout> layout(
        m, "NodeLayout",
        "The nodes that a pattern may use, and the edges that it may choose.\n\n>>> import fretwork\n>>> "
        "layout = fretwork.find_node_layout('paper7')\n>>> len(layout.nodes), "
        "len(layout.candidate_edges)\n(7, 17)\n>>> layout.candidate_edges[0]\n(0, 1)\n");
    layout
        .def(py::init([](std::string name, bool center, bool corners, std::vector<Rational> radial,
                         std::vector<std::array<Rational, 3>> face, std::vector<Rational> interface) {
                 return NodeLayout({std::move(name), center, corners, std::move(radial), std::move(face),
                                    std::move(interface)});
             }),
             "name"_a, py::kw_only(), "center"_a = true, "corners"_a = false,
             "radial"_a = std::vector<Rational>{}, "face"_a = std::vector<std::array<Rational, 3>>{},
             "interface"_a = std::vector<Rational>{},
             "Make a layout of your own. Places are exact: ints, Fractions, or texts such as "
             "'1/3'.\n\nradial: distances from v0 along v0 v1 and v0 v2, as shares of their length\nface: "
             "barycentric places (v0, v1, v2)\ninterface: distances from v1 along v1 v2, as shares of its "
             "length\n\nRaises InputError that names the node and the rule which it breaks.\n\n>>> import "
             "fretwork\n>>> own = fretwork.NodeLayout('own', radial=['1/2'], interface=['1/2'])\n>>> "
             "len(own.nodes)\n4\n")
        .def_property_readonly("name", [](const NodeLayout& self) { return self.name(); })
        .def_property_readonly(
            "nodes",
            [](const NodeLayout& self) {
                return Frozen<base::IndexVector<LayoutNodeIndex, LayoutNode>>{self.nodes()};
            },
            "Tuple of LayoutNode: center, radial nodes on v0 v1, radial nodes on v0 v2, face nodes, "
            "interface nodes, corners.")
        .def_property_readonly(
            "places",
            [](const NodeLayout& self) {
                Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> places(self.nodes().size(), 3);
                for (std::size_t n = 0; n < self.nodes().size(); ++n)
                    for (std::size_t c = 0; c < 3; ++c)
                        places(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(c)) =
                            self.nodes()[n].place[c].to_double();
                return places;
            },
            "n x 3 floats: the barycentric coordinates of the nodes.")
        .def_property_readonly(
            "candidate_edges",
            [](const NodeLayout& self) {
                Frozen<std::vector<std::pair<int, int>>> edges;
                for (const Edge& edge : self.candidate_edges())
                    edges.value.emplace_back(edge.first, edge.second);
                return edges;
            },
            "Tuple of pairs of nodes (i, j), i < j, sorted.")
        .def_property_readonly("interface_nodes", &NodeLayout::interface_nodes,
                               "Numbers of the interface nodes, from v1 to v2.")
        .def(
            "left_partner",
            [](const NodeLayout& self, int node) {
                return self.left_partner(LayoutNodeIndex(checked_index(node, self.nodes().size(), "node")));
            },
            "node"_a,
            "For a node on v0 v2, its partner on v0 v1, which is the same node of the fan in the next "
            "sector; for any other node, the node itself.")
        .def(
            "__eq__", [](const NodeLayout& self, const NodeLayout& other) { return self == other; },
            py::is_operator())
        .def("__hash__", [](const NodeLayout& self) { return py::hash(py::str(node_layout_text(self))); })
        .def("__repr__",
             [](const NodeLayout& self) {
                 return "<NodeLayout " + self.name() + ": " + std::to_string(self.nodes().size()) +
                        " nodes, " + std::to_string(self.candidate_edges().size()) + " candidate edges>";
             })
        .def(py::pickle([](const NodeLayout& self) { return py::make_tuple(node_layout_text(self)); },
                        [](const py::tuple& state) {
                            return parse_node_layout(py::cast<std::string>(state[0]), "pickle");
                        }));
}

void bind_layout_functions(py::module_& m) {
    m.def("read_node_layout", &read_node_layout, "path"_a, "Read a layout file. Raises InputError.");
    m.def("node_layout_text", &node_layout_text, "layout"_a, "The text of a layout file.");
    m.def("parse_node_layout", &parse_node_layout, "text"_a, "source"_a = "text",
          "The inverse of node_layout_text.");
    m.def("layout_names", &layout_names, "The names of the built-in layouts.");
    m.def(
        "paper_layout", [] { return paper_layout(); }, "The paper's layout, 'paper7'.");
    m.def("find_node_layout", &find_node_layout, "name_or_path"_a,
          "The built-in layout with a name or, if there is none, the layout in the file with this "
          "path.\n\n>>> import fretwork\n>>> fretwork.find_node_layout('paper7').name\n'paper7'\n");
}

void bind_pattern(py::module_& m) {
    py::class_<Pattern>(m, "Pattern",
                        "A set of candidate edges of one layout, by their numbers.\n\n"
                        ">>> import fretwork\n"
                        ">>> layout = fretwork.paper_layout()\n"
                        ">>> pattern = fretwork.parse_pattern_id(layout, '0-1+1-6')\n"
                        ">>> len(pattern)\n"
                        "2\n"
                        ">>> fretwork.pattern_id(layout, pattern)\n"
                        "'0-1+1-6'\n")
        .def(py::init<const Pattern::Bits&>(), "edges"_a = Pattern::Bits{})
        .def_property_readonly(
            "edges", [](const Pattern& self) { return self.bits(); },
            "The numbers of the chosen candidate edges, ascending.")
        .def_property_readonly("edge_count", &Pattern::edge_count)
        .def(
            "has",
            [](const Pattern& self, int edge) {
                return self.has(EdgeIndex(checked_index(edge, kMaxCandidateEdges, "candidate edge")));
            },
            "edge"_a)
        .def("__contains__",
             [](const Pattern& self, int edge) {
                 return edge >= 0 && edge < kMaxCandidateEdges && self.has(EdgeIndex(edge));
             })
        .def("__len__", &Pattern::edge_count)
        .def(
            "__eq__", [](const Pattern& self, const Pattern& other) { return self == other; },
            py::is_operator())
        .def("__hash__", [](const Pattern& self) { return std::hash<Pattern::Bits>{}(self.bits()); })
        .def("__repr__",
             [](const Pattern& self) {
                 return "Pattern(" + py::cast<std::string>(py::repr(py::cast(self.bits()))) + ")";
             })
        .def(py::pickle([](const Pattern& self) { return py::make_tuple(self.bits()); },
                        [](const py::tuple& state) { return Pattern(py::cast<Pattern::Bits>(state[0])); }));
    m.attr("MAX_CANDIDATE_EDGES") = kMaxCandidateEdges;
    Record<NamedPattern>(m, "NamedPattern", "A pattern and its id in its layout.")
        .field("id", &NamedPattern::id, "")
        .field("pattern", &NamedPattern::pattern, "")
        .done();
}

void bind_pattern_functions(py::module_& m) {
    m.def("find_edge", &find_edge, "layout"_a, "text"_a, "The candidate edge of a text such as '1-6'.");
    m.def(
        "pattern_id",
        [](const NodeLayout& layout, const Pattern& pattern) {
            check(layout, pattern);
            return pattern_id(layout, pattern);
        },
        "layout"_a, "pattern"_a, "The id of a pattern, such as '0-1+1-6'. The format never changes.");
    m.def("parse_pattern_id", &parse_pattern_id, "layout"_a, "id"_a,
          "The pattern with an id, which may have the layout's name in front.");
    m.def(
        "named",
        [](const NodeLayout& layout, const Pattern& pattern) {
            check(layout, pattern);
            return named(layout, pattern);
        },
        "layout"_a, "pattern"_a, "A pattern with its id.");
    m.def("parse_named_pattern", &parse_named_pattern, "layout"_a, "id"_a,
          "The pattern with an id, as by parse_pattern_id(), together with the id that pattern_id() gives.");
    m.def(
        "parse_named_patterns",
        [](const NodeLayout& layout, const std::vector<std::string>& ids) {
            return parse_named_patterns(layout, ids);
        },
        "layout"_a, "ids"_a);
    m.def(
        "ids_of", [](const std::vector<NamedPattern>& patterns) { return ids_of(patterns); }, "patterns"_a,
        "The ids alone.");
    m.def(
        "mirror_image",
        [](const NodeLayout& layout, const Pattern& pattern) {
            check(layout, pattern);
            return Mirror(layout).image(pattern);
        },
        "layout"_a, "pattern"_a,
        "The mirror image of a pattern; None if the pattern uses a face node whose mirror image is not in "
        "the layout.");
    m.def(
        "is_symmetric",
        [](const NodeLayout& layout, const Pattern& pattern) {
            check(layout, pattern);
            return Mirror(layout).is_symmetric(pattern);
        },
        "layout"_a, "pattern"_a, "True if a pattern is its own mirror image.");
}

void bind_fan(py::module_& m) {
    Record<Fan> outer(
        m, "Fan",
        "A pattern repeated around a polygon: a graph without coordinates. Its first nodes are all "
        "interface nodes, side by side.");
    Record<Fan::Node>(outer.type(), "Node", "A node of a fan: a node of the layout, in a sector.")
        .constant("layout_node", &Fan::Node::layout_node, "")
        .constant("sector", &Fan::Node::sector, "")
        .done(Made::ByFunctions);
    outer.constant("sides", &Fan::sides, "")
        .constant("interface_node_count", &Fan::interface_node_count,
                  "number of interface nodes on all sides together")
        .constant("nodes", &Fan::nodes, "")
        .constant("edges", &Fan::edges, "pairs of nodes, each once, smaller node first; sorted")
        .done(Made::ByFunctions);
    m.def(
        "make_fan",
        [](const NodeLayout& layout, const Pattern& pattern, int sides) {
            check(layout, pattern);
            return make_fan(layout, pattern, sides);
        },
        "layout"_a, "pattern"_a, "sides"_a = kReferenceSides, "Repeat a pattern around a polygon.");
    m.def(
        "place_fan",
        [](const NodeLayout& layout, const Fan& fan, const geometry::Polygon& polygon) {
            for (const Fan::Node& node : fan.nodes)
                checked_index(node.layout_node.value, layout.nodes().size(), "node of this layout");
            return place_fan(layout, fan, polygon);
        },
        "layout"_a, "fan"_a, "polygon"_a,
        "The positions (m) of the nodes of a fan in a convex polygon (n x 2, m), one row for each node.");
    m.def("regular_polygon", &geometry::regular_polygon, "sides"_a, "side"_a,
          "The regular polygon around the origin whose first side faces down; `side` in m. n x 2 floats.");
}

}  // namespace

void bind_patterns(py::module_& m) {
    bind_layout(m);
    bind_layout_functions(m);
    bind_pattern(m);
    bind_pattern_functions(m);
    bind_fan(m);
}

}  // namespace fretwork::python
