// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>

#include <bitset>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::pattern {

/// The largest number of candidate edges that a layout may have.
inline constexpr int kMaxCandidateEdges = 128;

/// A set of candidate edges of one layout: bit e is set if candidate edge e is chosen.
class Pattern {
  public:
    /// A set of candidate edges, one bit for each.
    using Bits = std::bitset<kMaxCandidateEdges>;

    Pattern() = default;
    /// The pattern of these edges.
    explicit Pattern(const Bits& edges) : edges_(edges) {}

    /// The edges as bits.
    [[nodiscard]] const Bits& bits() const { return edges_; }
    /// The number of edges.
    [[nodiscard]] int edge_count() const { return static_cast<int>(edges_.count()); }
    /// True if the pattern has the edge.
    [[nodiscard]] bool has(EdgeIndex edge) const { return edges_.test(edge.value); }
    /// The edges, ascending.
    [[nodiscard]] std::vector<EdgeIndex> edges() const;
    friend bool operator==(const Pattern&, const Pattern&) = default;

  private:
    Bits edges_;
};

/// The candidate edge of a text such as "1-6". Throws InputError if there is no such candidate.
EdgeIndex find_edge(const NodeLayout& layout, std::string_view text);

/// The id of a pattern, such as "0-1+1-6": the edges i-j of the pattern with i < j, sorted by i and then j as
/// numbers. The format never changes.
std::string pattern_id(const NodeLayout& layout, const Pattern& pattern);

/// The pattern with an id, which may have the layout's name in front ("paper7:0-1+1-6"). The edges may come
/// in any order. Throws InputError if the text is not an id, or if it names another layout, an edge that is
/// not a candidate, or an edge twice.
Pattern parse_pattern_id(const NodeLayout& layout, std::string_view id);

/// A pattern and its id in its layout.
struct NamedPattern {
    std::string id;     ///< the id that pattern_id() gives
    Pattern pattern{};  ///< the edges of the pattern
    friend bool operator==(const NamedPattern&, const NamedPattern&) = default;
};
/// A pattern with its id.
NamedPattern named(const NodeLayout& layout, const Pattern& pattern);
/// The pattern with an id, parsed as by parse_pattern_id(). The id in the result is the id that pattern_id()
/// gives.
NamedPattern parse_named_pattern(const NodeLayout& layout, std::string_view id);
/// The patterns with these ids. Throws as parse_named_pattern().
std::vector<NamedPattern> parse_named_patterns(const NodeLayout& layout, std::span<const std::string> ids);
/// The ids of the patterns.
std::vector<std::string> ids_of(std::span<const NamedPattern> patterns);

}  // namespace fretwork::pattern
