// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/enumerate.hpp>

#include <vector>

namespace fretwork::pattern {

/// A rejected graph and the verdict that rejects it.
struct Rejection {
    Pattern pattern;  ///< the rejected graph
    Verdict verdict;  ///< the filter that rejects the graph, the reason, and the guilty edges
};

/// Find examples of rejected graphs: for each filter, in the order of the census, up to `per_filter` graphs
/// that break only the rule of this filter. The examples of a filter are drawn, evenly spread, from such
/// graphs with the fewest edges: the range of the number of edges grows from its lower end until enough
/// graphs are found. A filter gets fewer than `per_filter` examples if the million graphs with the fewest
/// edges contain no more.
std::vector<Rejection> find_rejections(const NodeLayout& layout, const EnumerationOptions& options,
                                       std::size_t per_filter);

}  // namespace fretwork::pattern
