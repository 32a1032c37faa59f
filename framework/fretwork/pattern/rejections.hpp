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

/// Examples of rejected graphs. For each filter, in the order of the census, up to `per_filter` graphs break
/// its rule and no other. They are spread over all such graphs of the smallest numbers of edges that provide
/// enough. A filter gets fewer, or none, if the simplest million graphs hold fewer.
std::vector<Rejection> find_rejections(const NodeLayout& layout, const EnumerationOptions& options,
                                       std::size_t per_filter);

}  // namespace fretwork::pattern
