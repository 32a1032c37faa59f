// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/filters.hpp>

namespace fretwork::pattern::detail {

// Paper, Section 4.2, "Dangling parts".
Rule make_articulation(const NodeLayout&, double, const FabricationScale&) {
    return GraphRule{GraphRule::Property::WithoutArticulation};
}

}  // namespace fretwork::pattern::detail
