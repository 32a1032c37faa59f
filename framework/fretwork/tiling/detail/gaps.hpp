// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/tiling/detail/dual.hpp>

namespace fretwork::tiling::detail {

/// Close the wedges between tiles of a narrow part. Where a triangle of three rim points parts two tiles,
/// they only touch at one vertex, and end on the opposite outline at two places; these become one place, and
/// the tiles share a side. A wedge stays open where a tile would lose its convexity.
/// Throws base::Stopped.
void close_gaps(Dual& dual, const base::Control& control);

/// At how many vertices the rim of the tiles touches itself: the gaps that are left. Throws base::Stopped.
int count_pinches(const Dual& dual, const base::Control& control);

}  // namespace fretwork::tiling::detail
