// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/shape.hpp>

#include <vector>

namespace fretwork::fabrication {

/// A place where the contours of the material come near each other, or an opening is narrow.
struct NarrowPlace {
    /// The kind of a narrow place.
    enum class Kind {
        Gap,      ///< a gap between two edges of the material; it widens in both directions
        Opening,  ///< a narrow opening, with a sliver as cut-out; the place is its largest inner circle
    };
    Kind kind = Kind::Gap;       ///< kind of the place
    geometry::Point2 place;      ///< the middle of the gap or of the circle, m
    double width = 0.0;          ///< width of the gap, or diameter of the circle, m
    TileIndex tile;              ///< tile of the bar nearest to the place
    TessellationNodeIndex node;  ///< node nearest to the place
};

/// All places narrower than `clearance` (m), the narrowest first. Corners of openings between bars are not
/// gaps, because they do not widen in both directions. Throws Stopped.
std::vector<NarrowPlace> narrow_places(const Shape& shape, const BarPlan& plan, double clearance,
                                       const base::Control& control = {});

/// The largest circle inside an opening. The radius is at most 1 % (or 10 nm) too small.
struct InnerCircle {
    geometry::Point2 center;  ///< m
    double radius = 0.0;      ///< m
};
/// The largest circle in a polygon.
InnerCircle inner_circle(const geometry::Polygon& polygon);

}  // namespace fretwork::fabrication
