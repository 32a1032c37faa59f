// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/polygon.hpp>

#include <vector>

namespace fretwork::outlines::detail {

/// Make lines meet that nearly meet, so that the union of the loops has neither slits nor needles narrower
/// than `width` (metres): corners that are so near to each other become one, a side is led through a corner
/// so near to it, and corners of less than a quarter of a degree are cut off where their sides are twice as
/// far apart. Points so near to the one before them are left out first, if there is anything to do. Returns
/// how many such corners there were; the loops may touch and cross each other then.
int weld(const std::vector<geometry::Polygon*>& loops, double width);

}  // namespace fretwork::outlines::detail
