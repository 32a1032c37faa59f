// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/enumerate.hpp>

#include <vector>

namespace fretwork::pattern {

/// A rejected graph and the verdict that rejects it.
struct Rejection {
    Pattern pattern;  ///< the rejected graph
    Verdict verdict;  ///< why, and by which edges
};

/// Examples of rejected graphs. For each filter, in the order of the census, returns up to `per_filter`
/// graphs that break only its rule. Graphs with few edges come first: numbers of edges are admitted from the
/// smallest one up until there are enough such graphs, and the examples are spread evenly over these graphs.
/// A filter gets fewer examples, or none, if the simplest million graphs hold fewer.
std::vector<Rejection> find_rejections(const NodeLayout& layout, const EnumerationOptions& options,
                                       std::size_t per_filter);

}  // namespace fretwork::pattern
