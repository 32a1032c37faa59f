// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/filter_catalogue.hpp>

namespace fretwork::pattern::filters {

// The functions that state the rules of the rows of the filter catalogue.
Rule make_intersecting(const NodeLayout& layout, double value, const FabricationScale& scale);
Rule make_no_interface(const NodeLayout& layout, double value, const FabricationScale& scale);
Rule make_multiple_components(const NodeLayout& layout, double value, const FabricationScale& scale);
Rule make_articulation(const NodeLayout& layout, double value, const FabricationScale& scale);
Rule make_small_angle(const NodeLayout& layout, double value, const FabricationScale& scale);
Rule make_high_valence(const NodeLayout& layout, double value, const FabricationScale& scale);
Rule make_short_edge(const NodeLayout& layout, double value, const FabricationScale& scale);
Rule make_long_edge(const NodeLayout& layout, double value, const FabricationScale& scale);
Rule make_tight_clearance(const NodeLayout& layout, double value, const FabricationScale& scale);
Rule make_asymmetric(const NodeLayout& layout, double value, const FabricationScale& scale);

}  // namespace fretwork::pattern::filters
