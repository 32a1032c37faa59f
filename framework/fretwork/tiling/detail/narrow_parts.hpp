// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/outlines/outline.hpp>

#include <vector>

namespace fretwork::tiling::detail {

/// A place where an outline is narrow.
struct NarrowPlace {
    geometry::Point2 place;
    double width = 0.0;    ///< m
    double cut_off = 0.0;  ///< m2, the smaller area beside the cut; infinite if the shape stays connected
};

/// The limits that define a narrow place.
struct NarrowLimits {
    double width = 0.0;  ///< width, m, above which a place is not narrow
    /// area, m2, below which a part is ignored and left to the tile that it falls into
    double least_area = 0.0;
};

/// The places where the outline is narrow (a band, a limb, a sharp tip, the land between two holes), the
/// narrowest first. The boundary is sampled densely and triangulated; inner edges of the triangulation run
/// across the shape. Such an edge is at a narrow place if the part that it cuts off is at least as large as
/// the square of the width there, or if it cuts off no part. The corner of a wide plate is not narrow,
/// because the edge cuts off too little.
std::vector<NarrowPlace> narrow_places(const outlines::Outline& outline, const NarrowLimits& limits,
                                       const base::Control& control);

/// An outline without its sharpest tips, and the area of the removed tips, m2.
struct BluntOutline {
    outlines::Outline outline;
    double lost_area = 0.0;
};

/// The largest areas that blunting may remove, m2.
struct BluntLimits {
    double tip = 0.0;  ///< area removed at one tip
    double all = 0.0;
};

/// Cut off the ends of tips sharper than 31 degrees, and of hairs: dead ends so long and narrow that no tile
/// fits into them. `limits` bound the removed areas. The parts that are cut off stay uncovered.
/// @param narrow_width  m; points on the rim are at most a twentieth of this apart
BluntOutline blunt(const outlines::Outline& outline, double narrow_width, const BluntLimits& limits,
                   const base::Control& control);

}  // namespace fretwork::tiling::detail
