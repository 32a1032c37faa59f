// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/enumerate.hpp>

#include <vector>

namespace fretwork::pattern {

/// A graph that is no valid pattern, and why.
struct Rejection {
    Pattern pattern;
    Verdict verdict;
};

/// Examples of rejected graphs: for each filter, in the order of the census, up to `per_filter` graphs that
/// break its rule and no other. They have as few edges as possible, and are spread over all such graphs of as
/// many edges. A filter is left out where the simplest million graphs hold no example.
std::vector<Rejection> find_rejections(const NodeLayout& layout, const EnumerationOptions& options,
                                       std::size_t per_filter);

}  // namespace fretwork::pattern
