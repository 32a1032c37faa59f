// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/outlines/outline.hpp>
#include <fretwork/tiling/tessellate.hpp>

namespace fretwork::tiling::detail {

/// The smallest width of a part of an outline, and of a gap between two parts, as a share of the tiles' side.
inline constexpr double kNarrowest = 1e-4;

/// An outline, and the number of points that were left out.
struct CleanOutline {
    outlines::Outline outline;
    int left_out = 0;
};

/// Leave out the points that are negligible beside the tiles' side `edge` (m); see kNegligibleShare. Throws
/// GeometryError if points were left out and the loops are no longer an outline.
CleanOutline without_negligible_points(const outlines::Outline& outline, double edge,
                                       const base::Control& control);

/// Refuse an outline with two stretches nearer to each other than kNarrowest allows: a needle, a slit, a hole
/// that almost touches the boundary, a hole that is almost a point. No tile fits there, and triangles between
/// such stretches have no usable angles. Two stretches are different if the way between them along the
/// outline is at least a tenth of `edge`, or a quarter of their loop if that is less. Throws GeometryError
/// that names the place, the width and the smallest width allowed. Throws Stopped.
void check_small_parts(const outlines::Outline& outline, double edge, const base::Control& control);

}  // namespace fretwork::tiling::detail
