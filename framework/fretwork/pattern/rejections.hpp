// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/enumerate.hpp>

#include <vector>

namespace fretwork::pattern {

/// A rejected graph, and the reason.
struct Rejection {
    Pattern pattern;
    Verdict verdict;
};

/// Examples of rejected graphs: for each filter, in the order of the census, up to `per_filter` graphs that
/// break its rule and no other, spread over all such graphs of the smallest sizes that hold enough of them. A
/// filter has fewer, or none, where the simplest million graphs hold no more.
std::vector<Rejection> find_rejections(const NodeLayout& layout, const EnumerationOptions& options,
                                       std::size_t per_filter);

}  // namespace fretwork::pattern
