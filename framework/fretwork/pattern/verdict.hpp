// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/pattern.hpp>

#include <string>
#include <vector>

namespace fretwork::pattern {

/// What a filter says of a pattern. A rejection is a normal outcome, with its reason as data.
struct Verdict {
    bool accepted = true;
    std::string filter;             ///< the name of the filter that rejects; empty if accepted
    std::string reason;             ///< one sentence for people; empty if accepted
    std::vector<EdgeIndex> guilty;  ///< the beams to be drawn in red; empty where something is missing
};

}  // namespace fretwork::pattern
