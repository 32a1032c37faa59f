// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/pattern.hpp>

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace fretwork::pattern {

/// A filter's verdict on a pattern. A rejection is a normal outcome, and its reason is data.
struct Verdict {
    bool accepted = true;  ///< true if the pattern keeps the rule
    std::string filter;    ///< name of the filter that rejects the pattern; empty if accepted
    std::string reason;    ///< the reason for the rejection, one sentence; empty if accepted
    /// The edges that break the rule, drawn in red; empty if the pattern is rejected because it lacks an
    /// edge.
    std::vector<EdgeIndex> guilty;
};

// A filter states its rule in one of these five forms. The search, the census and the verdict know the forms,
// but no filter by name. The comment of each form states its cost, and how it prunes the search.

/// Certain pairs of edges may not be chosen together, and certain edges may not be chosen at all. Pruning:
/// adding edges to a pattern that breaks the rule does not mend it. Cost: one AND per edge.
struct ConflictRule {
    /// For each edge, the edges that conflict with it; symmetric. An edge that conflicts with itself is never
    /// chosen.
    base::IndexVector<EdgeIndex, Pattern::Bits> conflicts;
    std::string phrase;  ///< verb for messages: "cross", as in "the edges 0-1 and 2-5 cross"
    /// Verb for an edge that conflicts with itself: "is forbidden", as in "the edge 0-1 is forbidden".
    std::string self_phrase;
};

/// Each chosen edge loads resources (such as the nodes at its ends). The total load of each resource is at
/// most the limit. Pruning: adding edges to a pattern that breaks the rule does not mend it. Cost: one
/// addition per edge.
struct CapacityRule {
    /// A resource that edges load, such as a node.
    struct Resource {
        std::string name;                         ///< name in messages, such as "node n2"
        base::IndexVector<EdgeIndex, int> loads;  ///< load by each edge, zero or more
    };
    std::vector<Resource> resources;  ///< the resources that edges load
    int limit = 0;                    ///< largest load of a resource, zero or more
    /// Noun for messages: "valence", as in "node n2 has valence 8, above 6".
    std::string phrase;
};

/// A set of edges with a name for people: an edge, or all edges at a node.
struct EdgeGroup {
    std::string name;     ///< name for messages, such as "node n6"
    Pattern::Bits edges;  ///< the edges of the group
};

/// At least one edge of each group is chosen. Pruning: the search turns back once a group has neither a
/// chosen nor an available edge. Cost: one AND per group.
struct CoverRule {
    std::vector<EdgeGroup> groups;  ///< the groups, each with at least one edge in a pattern
    /// Words for messages: "no beam ends at", as in "no beam ends at interface node n6".
    std::string phrase;
};

/// The fan in the hexagon has a graph property. A verdict tests the property by Boost.Graph; the search uses
/// an equivalent bit-parallel test. Pruning: if both properties are required, the search turns back once some
/// loose end (an inner node where one beam ends) meets no available edge. Cost: a few graph searches with bit
/// sets.
struct GraphRule {
    /// The property that the fan's graph must have.
    enum class Property {
        Connected,  ///< the graph, without unused nodes, has at most one component
        /// If a further node outside is connected to all interface nodes, no node of the graph is an
        /// articulation point. The further node itself may be one.
        WithoutArticulation
    };
    Property property = Property::Connected;  ///< the property
};

/// Any other rule. Pruning: none. Cost: one call.
struct PredicateRule {
    std::function<bool(const Pattern&)> is_kept;  ///< returns true if the pattern keeps the rule
    /// Sentence for messages: "the pattern is not its own mirror image".
    std::string phrase;
};

/// A rule in one of the five forms.
using Rule = std::variant<ConflictRule, CapacityRule, CoverRule, GraphRule, PredicateRule>;

}  // namespace fretwork::pattern
