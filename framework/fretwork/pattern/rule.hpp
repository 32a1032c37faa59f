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
    bool accepted = true;           ///< it keeps the rule
    std::string filter;             ///< the name of the filter that rejects; empty if accepted
    std::string reason;             ///< one sentence for people; empty if accepted
    std::vector<EdgeIndex> guilty;  ///< the edges to be drawn in red; empty if the pattern lacks an edge
};

// The forms in which a filter may state its rule. The search, the census and the verdict know these forms and
// no filter by name. Each form declares its cost and how it prunes the search.

/// Certain pairs of edges may not be chosen together, and certain edges may not be chosen at all. Prunes: a
/// broken rule stays broken when edges are added. Cost: one AND per edge.
struct ConflictRule {
    /// Symmetric; an edge in conflict with itself is never chosen.
    base::IndexVector<EdgeIndex, Pattern::Bits> conflicts;
    std::string phrase;       ///< "cross", as in "the edges 0-1 and 2-5 cross"
    std::string self_phrase;  ///< "is forbidden", as in "the edge 0-1 is forbidden"
};

/// Each resource (such as the valence of a node) bears a load from each chosen edge, up to a limit.
/// Prunes: a broken rule stays broken when edges are added. Cost: one addition per edge.
struct CapacityRule {
    /// Something that edges load, such as a node.
    struct Resource {
        std::string name;                         ///< "node n2"
        base::IndexVector<EdgeIndex, int> loads;  ///< zero or more
    };
    std::vector<Resource> resources;  ///< what each edge loads
    int limit = 0;                    ///< the largest load of each
    std::string phrase;               ///< "valence", as in "node n2 has valence 8, above 6"
};

/// A set of edges with a name for people: an edge, or all edges at a node.
struct EdgeGroup {
    std::string name;     ///< "node n6"
    Pattern::Bits edges;  ///< of which one has to be there
};

/// At least one edge of each group is chosen. Prunes once no edge of a group is available any more. Cost: one
/// AND per group.
struct CoverRule {
    std::vector<EdgeGroup> groups;  ///< each has to be covered
    std::string phrase;             ///< "no beam ends at", as in "no beam ends at node n6"
};

/// A graph property of the fan in the hexagon. Boost.Graph defines it; the search uses an equivalent
/// bit-parallel test. It does not prune by itself. Cost: a few graph searches with bit sets.
struct GraphRule {
    /// What the fan's graph has to be.
    enum class Property {
        Connected,           ///< one component
        WithoutArticulation  ///< no articulation point when a further node outside connects all interface
                             ///< nodes
    };
    Property property = Property::Connected;  ///< which one
};

/// Any other rule. It does not prune. Cost: one call.
struct PredicateRule {
    std::function<bool(const Pattern&)> is_kept;  ///< true for patterns that keep the rule
    std::string phrase;                           ///< "the pattern is not its own mirror image"
};

/// One of five forms; the search prunes by the first four.
using Rule = std::variant<ConflictRule, CapacityRule, CoverRule, GraphRule, PredicateRule>;

}  // namespace fretwork::pattern
