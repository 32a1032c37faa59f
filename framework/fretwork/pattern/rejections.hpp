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
/// that break only this filter's rule. Graphs are tested in order of their number of edges, until all filters
/// have enough examples or a million graphs were tested. The examples of a filter are spread evenly over the
/// graphs found. Throws as for_each_pattern().
std::vector<Rejection> find_rejections(const NodeLayout& layout, const EnumerationOptions& options,
                                       std::size_t per_filter);

}  // namespace fretwork::pattern
