// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/filters/filters.hpp>

namespace fretwork::pattern::filters {

// Paper, Section 4.2, "Multiple-connected components".
Rule make_multiple_components(const NodeLayout&, double, const FabricationScale&) {
    return GraphRule{GraphRule::Property::Connected};
}

// Paper, Section 4.2, "Dangling parts".
Rule make_articulation(const NodeLayout&, double, const FabricationScale&) {
    return GraphRule{GraphRule::Property::WithoutArticulation};
}

}  // namespace fretwork::pattern::filters
