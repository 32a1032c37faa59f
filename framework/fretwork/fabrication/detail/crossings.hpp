// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/bar_plan.hpp>

namespace fretwork::fabrication::detail {

/// Check that bars meet in nodes only. Throws GeometryError that names the first two bars that cross, touch
/// (within a nanometre) or lie over each other, by their tiles.
void require_no_crossings(const BarPlan& plan);

}  // namespace fretwork::fabrication::detail
