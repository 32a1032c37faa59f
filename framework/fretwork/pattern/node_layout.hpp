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

/// The index of a node of a layout. The paper's nodes n0 .. n6 have the indices 0 .. 6.
using LayoutNodeIndex = base::Index<struct LayoutNodeTag>;
/// The index of a candidate edge, in the order of NodeLayout::candidate_edges().
using EdgeIndex = base::Index<struct EdgeTag>;

/// The region of the base triangle in which a node lies. Paper, Fig. 3a.
enum class Region {
    Center,       ///< the node lies at v0
    LeftRadial,   ///< the node lies on v0 v1
    RightRadial,  ///< the node lies on v0 v2, which is v0 v1 of the next sector
    Face,         ///< the node lies inside the triangle
    Interface,    ///< the node lies on v1 v2
    Corner        ///< the node lies at v1 or v2; not used, because layouts may not have such nodes
};

/// A node of the base triangle v0 v1 v2; v0 is the polygon's centroid, v1 and v2 are the ends of one of its
/// sides.
struct LayoutNode {
    Region region;                  ///< the region in which the node lies
    std::array<Rational, 3> place;  ///< exact barycentric coordinates for (v0, v1, v2), with sum 1
};

/// A candidate edge i-j, first < second.
struct Edge {
    LayoutNodeIndex first;   ///< the smaller index
    LayoutNodeIndex second;  ///< the larger index
    friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// The content of a layout file; experiments/layouts/README.md shows how to write one.
struct NodeLayoutDescription {
    std::string name;              ///< name of the layout: letters, digits, `-`, `_`
    bool center = true;            ///< true if v0 is a node
    bool corners = false;          ///< must be false: v1 and v2 may not be nodes
    std::vector<Rational> radial;  ///< distances from v0 along v0 v1 and v0 v2, as shares of their length
    std::vector<std::array<Rational, 3>> face;  ///< barycentric coordinates for (v0, v1, v2)
    std::vector<Rational> interface;            ///< distances from v1 along v1 v2, as shares of its length
    friend bool operator==(const NodeLayoutDescription&, const NodeLayoutDescription&) = default;
};

/// The nodes that a pattern may use, and the edges that it may choose. Threads may share a NodeLayout, which
/// is immutable.
///
/// Numbering: center, radial nodes on v0 v1, radial nodes on v0 v2, face nodes, interface nodes (from v1 to
/// v2). Candidate edges are sorted by first, then second node. Three kinds of edges are not
/// candidates: edges along the right radial side (the left radial side gives the same fan), edges along the
/// interface side, and edges that pass through another node. Paper, Sections 4.1 and 4.2.
class NodeLayout {
  public:
    /// Make a layout from its description. Throws InputError that names the broken rule and, if one node
    /// breaks it, this node. A layout has from 1 to kMaxCandidateEdges candidate edges.
    explicit NodeLayout(NodeLayoutDescription description);

    /// The description from which the layout was made.
    [[nodiscard]] const NodeLayoutDescription& description() const { return description_; }
    /// The name of the layout, which may stand before a pattern id.
    [[nodiscard]] const std::string& name() const { return description_.name; }
    /// The nodes, in the order of their numbers.
    [[nodiscard]] const base::IndexVector<LayoutNodeIndex, LayoutNode>& nodes() const { return nodes_; }
    /// The candidate edges, sorted.
    [[nodiscard]] const base::IndexVector<EdgeIndex, Edge>& candidate_edges() const { return edges_; }
    /// The interface nodes, from v1 to v2.
    [[nodiscard]] std::vector<LayoutNodeIndex> interface_nodes() const;
    /// The node on v0 v1 that coincides, in the next sector of the fan, with this node on v0 v2. For a node
    /// that is not on v0 v2, the node itself.
    [[nodiscard]] LayoutNodeIndex left_partner(LayoutNodeIndex node) const;
    /// Two layouts are equal if their descriptions are, names included.
    friend bool operator==(const NodeLayout& left, const NodeLayout& right) {
        return left.description_ == right.description_;
    }

  private:
    NodeLayoutDescription description_;
    base::IndexVector<LayoutNodeIndex, LayoutNode> nodes_;
    base::IndexVector<EdgeIndex, Edge> edges_;
};

/// Read a layout file. Throws InputError with file and place.
NodeLayout read_node_layout(const std::filesystem::path& path);

/// The layout as the text of a layout file, as libraries store it.
std::string node_layout_text(const NodeLayout& layout);
/// The inverse of node_layout_text; `source` names the text in messages. Throws as read_node_layout().
NodeLayout parse_node_layout(std::string_view text, std::string source);

/// The names of the built-in layouts; the paper's layout comes first.
std::vector<std::string> layout_names();
/// True if a built-in layout has this name.
bool is_layout_name(std::string_view name);

/// The paper's layout, "paper7", read once. Several threads may call this function at once.
const NodeLayout& paper_layout();

/// The built-in layout with this name ("paper7") or, if there is none, the layout in the file with this path.
/// Throws InputError.
NodeLayout find_node_layout(std::string_view name_or_path);

}  // namespace fretwork::pattern
