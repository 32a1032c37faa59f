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
    double cut_off = 0.0;  ///< m2, the smaller of the areas on both sides; infinite if they are one
};

/// The measure of narrow.
struct NarrowLimits {
    double width = 0.0;       ///< m; what is wider is not narrow
    double least_area = 0.0;  ///< m2; smaller parts are left to whatever tile they fall into
};

/// The places where the outline is narrow: a band, a limb, a sharp tip, the land between two holes. Found on
/// the triangulation of its densely sampled boundary, whose edges inside run across the shape: such an edge
/// is at a narrow place if the part that it cuts off is at least as large as the square of its length, or
/// stays connected another way. (The corner of a wide plate is not narrow: the edge cuts off too little.)
std::vector<NarrowPlace> narrow_places(const outlines::Outline& outline, const NarrowLimits& limits,
                                       const base::Control& control);

/// An outline without its sharpest tips, and the area that they had, m2.
struct BluntOutline {
    outlines::Outline outline;
    double lost_area = 0.0;
};

/// How much blunting may take away, m2.
struct BluntLimits {
    double tip = 0.0;  ///< at one tip
    double all = 0.0;
};

/// Cut off tips that are sharper than 31 degrees, and hairs: dead ends so long and narrow that no tile fits
/// into their ends. The parts that are cut off stay uncovered.
BluntOutline blunt(const outlines::Outline& outline, double narrow_width, const BluntLimits& limits,
                   const base::Control& control);

}  // namespace fretwork::tiling::detail
