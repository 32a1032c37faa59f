// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/shape.hpp>

#include <vector>

namespace fretwork::fabrication {

/// Where two sides of what is cut come near each other.
struct NarrowPlace {
    enum class Kind {
        Gap,      ///< a throat: material faces material over a gap that widens on both sides
        Opening,  ///< an opening of which this is the largest circle that fits into it: a sliver falls out
    };
    Kind kind = Kind::Gap;
    geometry::Point2 place;      ///< the middle of the gap or of the circle, m
    double width = 0.0;          ///< m
    TileIndex tile;              ///< of the nearest bar
    TessellationNodeIndex node;  ///< the nearest one
};

/// All places narrower than `clearance` (m), the narrowest first. Openings between bars end in corners; those
/// are no gaps, fillets round them.
/// Throws Stopped.
std::vector<NarrowPlace> narrow_places(const Shape& shape, const BarPlan& plan, double clearance,
                                       const base::Control& control = {});

/// The largest circle inside of an opening; off by at most a hundredth of it.
struct InnerCircle {
    geometry::Point2 center;
    double radius = 0.0;  ///< m
};
InnerCircle inner_circle(const geometry::Polygon& polygon);

}  // namespace fretwork::fabrication
