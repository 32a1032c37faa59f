// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/filters.hpp>

namespace fretwork::pattern::detail {

// Paper, Section 4.2, "Multiple-connected components".
Rule make_multiple_components(const NodeLayout&, double, const FabricationScale&) {
    return GraphRule{GraphRule::Property::Connected};
}

}  // namespace fretwork::pattern::detail
