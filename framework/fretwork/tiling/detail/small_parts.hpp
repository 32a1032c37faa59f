// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/outlines/outline.hpp>
#include <fretwork/tiling/tessellate.hpp>

namespace fretwork::tiling::detail {

/// No part of an outline, and no gap between two of its parts, may be narrower than this share of the tiles'
/// side.
inline constexpr double kNarrowest = 1e-4;

/// An outline, and how many of its points were left out.
struct CleanOutline {
    outlines::Outline outline;
    int left_out = 0;
};

/// Leave out the points that are negligible beside the tiles' side `edge` (metres): kNegligibleShare. Throws
/// GeometryError if a loop has less than three others.
CleanOutline without_negligible_points(const outlines::Outline& outline, double edge,
                                       const base::Control& control);

/// Refuse an outline of which two parts are nearer to each other than kNarrowest allows: a needle, a slit, a
/// hole that almost touches, a hole that is almost a point. No tile fits there, and triangles between such
/// parts have no usable angles. Parts count as two if the way between them along the outline is at least a
/// tenth of `edge`. Throws GeometryError that names the place, the width and the least allowed; Stopped.
void check_small_parts(const outlines::Outline& outline, double edge, const base::Control& control);

}  // namespace fretwork::tiling::detail
