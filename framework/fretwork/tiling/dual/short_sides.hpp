// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/dual/dual.hpp>
#include <fretwork/tiling/remeshing/size_field.hpp>

namespace fretwork::tiling::detail {

/// Make one vertex of the ends of sides that are much shorter than the tiles' sides there, or shorter than
/// the smallest side allowed (metres), where the tiles keep three sides and the rim stays a simple curve.
/// Returns how many.
int collapse_short_sides(Dual& dual, const SizeField& field, double smallest_side,
                         const base::Control& control);

}  // namespace fretwork::tiling::detail
