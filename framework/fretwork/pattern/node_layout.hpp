// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/index_vector.hpp>
#include <fretwork/pattern/rational.hpp>

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::pattern {

/// A node of a layout: the paper's n0 .. n6 are 0 .. 6.
using LayoutNodeIndex = base::Index<struct LayoutNodeTag>;
/// A candidate edge of a layout, in the order of NodeLayout::candidate_edges().
using EdgeIndex = base::Index<struct EdgeTag>;

/// The region of the base triangle in which a node lies. Paper, Fig. 3a.
enum class Region {
    Center,       ///< at v0
    LeftRadial,   ///< on v0 v1
    RightRadial,  ///< on v0 v2: the left one of the next sector
    Face,         ///< inside
    Interface,    ///< on v1 v2
    Corner        ///< at v1 or v2
};

/// A node of the base triangle v0 v1 v2; v0 is the polygon's centroid, v1 and v2 are the ends of one of its
/// sides.
struct LayoutNode {
    Region region;                  ///< where on the triangle
    std::array<Rational, 3> place;  ///< barycentric coordinates (v0, v1, v2), exact, with sum 1
};

/// A candidate edge i-j, first < second.
struct Edge {
    LayoutNodeIndex first;   ///< the smaller index
    LayoutNodeIndex second;  ///< the larger one
    friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// The content of a layout file; experiments/layouts/README.md shows how to write one.
struct NodeLayoutDescription {
    std::string name;              ///< letters, digits, `-`, `_`
    bool center = true;            ///< a node at v0
    bool corners = false;          ///< nodes at v1 and v2: refused
    std::vector<Rational> radial;  ///< distances from v0 along v0 v1 and v0 v2, as shares of their length
    std::vector<std::array<Rational, 3>> face;  ///< barycentric places
    std::vector<Rational> interface;            ///< distances from v1 along v1 v2, as shares of its length
};

/// The nodes that a pattern may use, and the edges that it may choose from.
///
/// Numbering: center, radial nodes on v0 v1, radial nodes on v0 v2, face nodes, interface nodes (from v1 to
/// v2), corners. Candidate edges are sorted by first, then second node. Three kinds of edges are not
/// candidates: those along the right radial side (the left side gives the same fan), those along the
/// interface side, and those that pass through another node. Paper, Sections 4.1 and 4.2.
class NodeLayout {
  public:
    /// Throws InputError that names a node and the rule that it breaks.
    explicit NodeLayout(NodeLayoutDescription description);

    /// What it was made from.
    [[nodiscard]] const NodeLayoutDescription& description() const { return description_; }
    /// Its name, which stands before pattern ids.
    [[nodiscard]] const std::string& name() const { return description_.name; }
    /// Center, left radial, right radial, face, interface.
    [[nodiscard]] const base::IndexVector<LayoutNodeIndex, LayoutNode>& nodes() const { return nodes_; }
    /// The pairs that a pattern may choose.
    [[nodiscard]] const base::IndexVector<EdgeIndex, Edge>& candidate_edges() const { return edges_; }
    /// The interface nodes, from v1 to v2.
    [[nodiscard]] std::vector<LayoutNodeIndex> interface_nodes() const;
    /// The partner on v0 v1 of a node on v0 v2: both are the same node of the fan, in neighbouring sectors.
    /// Any other node is its own partner.
    [[nodiscard]] LayoutNodeIndex left_partner(LayoutNodeIndex node) const;

  private:
    NodeLayoutDescription description_;
    base::IndexVector<LayoutNodeIndex, LayoutNode> nodes_;
    base::IndexVector<EdgeIndex, Edge> edges_;
};

/// Read a layout file. Throws InputError with file and place.
NodeLayout read_node_layout(const std::filesystem::path& path);

/// The layout as the text of a layout file, as libraries store it.
std::string node_layout_text(const NodeLayout& layout);
/// The inverse of node_layout_text; `source` names the text in messages.
NodeLayout parse_node_layout(std::string_view text, std::string source);

/// The names of the built-in layouts, the paper's first.
std::vector<std::string> layout_names();

/// The paper's layout, "paper7", read once. Safe to call from several threads.
const NodeLayout& paper_layout();

/// The built-in layout with this name ("paper7"), or else the layout in this file. Throws InputError.
NodeLayout find_node_layout(std::string_view name_or_path);

}  // namespace fretwork::pattern
