// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>

namespace fretwork::tiling::detail {

/// Make one cell of neighbours where cells are wanted smaller, as long as that gives convex cells without
/// sharp angles whose sides are at most 1.5 times the largest wanted side. So a narrow band gets few long
/// cells. Points of the rim between two merged cells are removed if the outline is nearly straight there.
void merge_small_cells(Dual& dual, const SizeField& field, const base::Control& control);

}  // namespace fretwork::tiling::detail
